#pragma once
#include <string>
#include <string_view>

namespace course {

enum class Colour { red = 31, green = 32, yellow = 33, dim = 2, bold = 1 };

/// The text between the codes of a terminal that put it in that colour.
inline std::string in_colour(Colour colour, std::string_view text) {
    return "\033[" + std::to_string(static_cast<int>(colour)) + "m" + std::string{text} + "\033[0m";
}

/// Whether standard output is one.
bool is_terminal();

/// The text in that colour on terminals that support it (TERM is not "dumb"), unless NO_COLOR is set; else as it is.
std::string painted(Colour colour, std::string_view text);

/// Whether there is a terminal on which a question can be asked and answered.
bool can_ask();

/// Asks on the terminal; only "y" or "yes" is a yes.
bool ask(std::string_view question);

} // namespace course
