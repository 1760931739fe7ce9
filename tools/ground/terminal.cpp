#include "ground/terminal.hpp"

#include <cstdlib>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace course {

bool is_terminal(Stream stream) { return ::isatty(static_cast<int>(stream)) == 1; }

bool has_colour(Stream stream) {
    const char *unwanted = std::getenv("NO_COLOR"); // no-color.org: set and not empty
    const char *term = std::getenv("TERM");
    return is_terminal(stream) && !(unwanted && *unwanted) && term && std::string_view{term} != "dumb";
}

std::string painted(Colour colour, std::string_view text, Stream stream) {
    if (!has_colour(stream)) return std::string{text};
    return "\033[" + std::to_string(static_cast<int>(colour)) + "m" + std::string{text} + "\033[0m";
}

int width(Stream stream) {
    winsize size{};
    const bool known = ::ioctl(static_cast<int>(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

bool can_ask() { return ::isatty(STDIN_FILENO) == 1 && is_terminal(Stream::err); }

bool ask(std::string_view question) {
    std::cerr << question << " [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes";
}

} // namespace course
