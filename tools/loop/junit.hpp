#pragma once
#include "ground/tree.hpp"
#include "verdict/shared/verdict.hpp"

#include <string>
#include <vector>

namespace course {

/// Verdicts as JUnit has them: a suite for each section, a case for each test, whose class is the exercise.
std::string junit(const std::vector<std::pair<Section, std::vector<Verdict>>> &judged);

} // namespace course
