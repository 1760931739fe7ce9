#pragma once
// Everybody's points as a table, for a platform that we don't know, or a spreadsheet.

#include "grade/graded.hpp"

#include <map>
#include <string>

namespace course {

/// A line for each student: id, name, total, possible, points of each exercise, and what stands in the way. Who has no
/// grade has no total. No cell is one that a spreadsheet would run.
/// @param names  of people, by id
std::string points_table(const GradedClass &graded, const std::map<std::string, std::string> &names);

} // namespace course
