#pragma once
// What compilers say, and the first steps of reading it.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace course {

/// What a compiler says of one error or warning.
struct Said {
    std::string words; ///< with plain quotes and short names
    std::string code;  ///< the line that it is about; empty if that is in another file than the student's
    std::string caret; ///< the line below, whose ^ is where the compiler stood
    std::string notes; ///< what follows, to the next error or warning, with plain quotes
};

/// `Vec2` for what a compiler calls it, Eigen::Matrix<double, 2, 1, 0, 2, 1>, and "expression of Vec2s" for the types that the
/// library computes with; without what they are "also known as".
std::string with_short_names(std::string text);

/// Everything in plain quotes.
std::vector<std::string> in_quotes(std::string_view words);

/// Whether a type holds one number.
bool is_number(std::string_view type);

/// Whether a type is a Vec2, or what one computes to.
bool is_vector(std::string_view type);

/// A struct of the course or the student's own: State, as the compiler writes it; or else nothing.
std::string struct_name(std::string_view type);

/// Where the bracket closes that stands at `from`, of any kind but < and >; or npos.
std::size_t where_it_closes(std::string_view code, std::size_t from);

/// a, b or (a, b): a comma that is in no inner brackets.
bool has_comma(std::string_view code);

/// A line of code without the blanks around it, and without what is behind its `//`.
std::string_view code_alone(std::string_view line);

/// The type that is asked for a member that it lacks, and that member's name; both empty if it is about something else.
std::pair<std::string, std::string> missing_member(const Said &said);

/// A name or a number with which this begins; or nothing.
std::string_view first_word(std::string_view code);

} // namespace course
