#pragma once
#include "loop/said.hpp"

#include <string>

namespace course {

/// What a beginner needs to know beside the words of GCC or Clang, for the slips that are made most, as a sentence of
/// its own; empty if there is nothing to add, or if the slip can only be guessed.
std::string advice(const Said &said);

} // namespace course
