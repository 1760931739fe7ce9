#pragma once
// What a wrong answer is known by: what all tests saw of it, but for those that generate their input.

#include "judge/protocol/verdict.hpp"

#include <string>
#include <vector>

namespace course {

/// What one test saw, as a verdict shows it: how it ended, and the values, with six digits, so that it doesn't matter in
/// what order somebody adds. Without file and line.
std::string seen_by(const Verdict &verdict);

/// A short name of all that these failed tests saw, in any order: sixteen digits.
std::string signature(const std::vector<Verdict> &failed);

} // namespace course
