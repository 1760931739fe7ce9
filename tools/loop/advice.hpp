#pragma once
#include <string>

namespace course {

/// What a beginner needs to know beside the compiler's words, for the slips that are made most, as a sentence of its
/// own; empty if there is nothing to add.
/// @param said  an error or a warning of the compiler, with plain quotes and short names
std::string advice(const std::string &said);

/// `Vec2` for what a compiler calls it, Eigen::Matrix<double, 2, 1, 0, 2, 1>, and "sum of Vec2s" for the types that the
/// library computes with; without what they are "also known as".
std::string with_short_names(std::string text);

} // namespace course
