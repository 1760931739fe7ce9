#pragma once
// What is said beside a compiler's words: the rules, and the sentences that more than one of them says.

#include "loop/said.hpp"

#include <initializer_list>
#include <string>

namespace course {

/// What a beginner needs to know beside the words of GCC or Clang, for the slips that are made most, as a sentence of
/// its own; empty if there is nothing to add, or if the slip can only be guessed.
std::string advice(const Said &said);

/// Knows some slips; of others it says nothing.
using Rule = std::string (*)(const Said &);

/// What the first says that knows the slip.
std::string first_of(std::initializer_list<Rule> rules, const Said &said);

/// "a Disc", "an Impact"
std::string with_article(const std::string &name);

/// "A Disc is wanted here: put its fields in braces, …"
std::string wanted(const std::string &name, const std::string &instead = "");

/// Whether something that is not a function is called as if it were one.
bool calls_no_function(const Said &said);

/// Slips that the student's line shows: a missing star, type or parenthesis.
std::string advice_on_code(const Said &said);

/// A type where another one is wanted; a struct that is wanted, or made in the wrong place.
std::string advice_on_types(const Said &said);

/// Lists: their elements, their functions, and loops over them; maps, and lists in them.
std::string advice_on_lists(const Said &said);

/// Names that are not known, and headers that have them.
std::string advice_on_names(const Said &said);

inline constexpr const char *missing_star = "Is a * missing? A product needs it: 2 * t, 2 * (a + b).";
inline constexpr const char *write_pi = "Write std::numbers::pi, and #include <numbers> at the top of your file.";
inline constexpr const char *length_of_vector = "The length of a Vec2 is a.norm().";
inline constexpr const char *copy_it = "It's const, so you can't change it: copy it, and change the copy.";
inline constexpr const char *two_components = "A Vec2 has two components: write Vec2{x, y}.";
inline constexpr const char *call_it = "A call needs parentheses: a.x(), not a.x.";
inline constexpr const char *no_call = "A field has no parentheses: write a.position, not a.position().";
inline constexpr const char *answer_nothing = "To answer nothing, write return {};";
inline constexpr const char *compare_it = "= gives a value; to compare, write ==.";
inline constexpr const char *missing_brace = "Is a } missing above this line?";
inline constexpr const char *write_dot = "For the dot product of two vectors write a.dot(b).";

} // namespace course
