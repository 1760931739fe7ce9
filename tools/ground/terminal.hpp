#pragma once
#include <string>
#include <string_view>

namespace course {

enum class Stream { out = 1, err = 2 };
enum class Colour { red = 31, green = 32, yellow = 33, blue = 34, dim = 2, bold = 1 };

bool is_terminal(Stream stream);

/// Colour is used on terminals that support it (TERM is not "dumb"), unless NO_COLOR is set.
bool has_colour(Stream stream);

/// The text in that colour, or as it is.
std::string painted(Colour colour, std::string_view text, Stream stream = Stream::out);

/// Columns of the terminal; 80 where there is none.
int width(Stream stream = Stream::out);

/// Whether standard input is a terminal, so that a question can be answered.
bool can_ask();

/// Asks on the terminal; only "y" or "yes" is a yes.
bool ask(std::string_view question);

} // namespace course
