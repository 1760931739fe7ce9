#pragma once
// Where the functions of exercises stand in a file that need not compile.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Code with blanks for all that is in comments and quotes. Its lines stay.
std::string code_of(std::string code);

/// A function's definition, as places in its file.
struct Definition {
    std::size_t begin = 0; ///< of its first line
    std::size_t body = 0;  ///< where its `{` is
    std::size_t end = 0;   ///< behind its `}`
    bool closed = true;    ///< it's not: the next function begins before its last brace

    bool holds(std::size_t place) const { return place >= begin && place < end; }
};

/// Where a line begins, counted from 1; the end of the text if it has fewer.
std::size_t line_begins(std::string_view text, int line);

/// The definition of a function, if there's one.
/// @param code    what `code_of` gives
/// @param others  functions that may come after it: none of them begins inside of it, whatever braces are missing
std::optional<Definition> definition_of(std::string_view code, std::string_view function,
                                        const std::vector<std::string> &others);

/// The definition of whatever function this place is in, as far as braces tell: those that follow brackets.
std::optional<Definition> function_around(std::string_view code, std::size_t place);

/// Whether code between these places calls a function.
bool calls(std::string_view code, const Definition &definition, std::string_view function);

} // namespace course
