#pragma once
#include <string>
#include <string_view>

namespace course {

/// What a compiler says of one error or warning.
struct Said {
    std::string words; ///< with plain quotes and short names
    std::string code;  ///< the line that it is about; empty if that is in another file than the student's
    std::string caret; ///< the line below, whose ^ is where the compiler stood
    std::string notes; ///< what follows, to the next error or warning, with plain quotes
};

/// What a beginner needs to know beside the words of GCC or Clang, for the slips that are made most, as a sentence of
/// its own; empty if there is nothing to add, or if the slip can only be guessed.
std::string advice(const Said &said);

/// `Vec2` for what a compiler calls it, Eigen::Matrix<double, 2, 1, 0, 2, 1>, and "expression of Vec2s" for the types that the
/// library computes with; without what they are "also known as".
std::string with_short_names(std::string text);

} // namespace course
