#pragma once
// A graded submission as Gradescope reads it.

#include "grade/graded.hpp"

#include <set>
#include <string>

namespace course {

/// Gradescope's results.json: a test for each exercise, with its points and what its student reads.
/// @param hidden  exercises of which students see nothing, by number
std::string gradescope_results(const GradedClass &graded, const Graded &judged, const std::set<std::string> &hidden);

} // namespace course
