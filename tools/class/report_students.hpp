#pragma once
#include "class/graded.hpp"
#include "class/report_html.hpp"

namespace course::report {

/// Whether there are points to show, or to count with: by a verdict, or by the instructor.
inline bool has_grade(const Graded &student) { return student.our_trouble.empty() || student.overridden; }

/// The class as a table: a row for each student, and below it, folded, what's wrong.
/// @param exercises  by number: its columns
std::string student_table(const GradedClass &graded, const People &people, const std::vector<std::string> &exercises);

} // namespace course::report
