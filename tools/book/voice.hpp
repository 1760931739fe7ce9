#pragma once
// How a chapter sounds, in numbers. What is meant is in CONTRIBUTING.md; a number only catches habits.

#include "book/finding.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace course {

/// Habits that a chapter in the voice has more often than it may. There are no exceptions.
std::vector<Finding> out_of_voice(std::string_view chapter, const std::filesystem::path &file);

} // namespace course
