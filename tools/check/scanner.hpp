#pragma once
// C++ source, read once from begin to end, whether it compiles or not: what's code, and which brackets belong
// together. Each step costs the length of the text, whatever is in it.

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Which brackets belong together: ( ) [ ] { }, but for those in lines of the preprocessor. A } closes all ( and [ that
/// are still open behind its {.
struct Brackets {
    explicit Brackets(std::string_view code);

    std::vector<std::size_t> closes;   ///< where the bracket at this place closes, or npos
    std::vector<std::size_t> stray;    ///< those that close nothing
    std::vector<std::size_t> unclosed; ///< those that nothing closes, in no order
};

/// A text as a compiler reads it.
struct Source {
    explicit Source(std::string_view text);

    std::string code; ///< with blanks for all that is in comments and quotes. Its lines stay
    std::vector<std::size_t> open_comments, open_quotes; ///< without an end: they end with their line
    std::vector<std::size_t> lines;                      ///< where each begins

    std::size_t line_begins(int line) const; ///< counted from 1; the end of the text if it has fewer
    int line_of(std::size_t place) const;
};

/// A line of code without the blanks around it, and without the comment behind it.
std::string_view code_alone(std::string_view line);

} // namespace course
