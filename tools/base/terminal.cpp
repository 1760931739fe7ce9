#include "base/terminal.hpp"

#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace course {
namespace {

bool has_colour() {
    const char *unwanted = std::getenv("NO_COLOR"); // no-color.org: set and not empty
    const char *term = std::getenv("TERM");
    return is_terminal() && !(unwanted && *unwanted) && term && std::string_view{term} != "dumb";
}

} // namespace

bool is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

std::string painted(Colour colour, std::string_view text) {
    return has_colour() ? in_colour(colour, text) : std::string{text};
}

bool can_ask() { return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1; }

bool ask(std::string_view question) {
    std::cerr << question << " [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes";
}

} // namespace course
