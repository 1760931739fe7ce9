#pragma once
#include "grade/graded.hpp"

#include <string>

namespace course {

/// What one student reads, as plain text: points, what isn't right and why. Nothing in it is about anybody else, or about
/// the machine that judged. It sends nobody to a command that a platform doesn't have, but to `update`, who has a
/// handout.
/// @param whole  every failing test, instead of the first of each exercise
std::string feedback(const GradedClass &graded, const Graded &student, bool whole);

/// The same in one line, for a gradebook's column of comments.
std::string comment(const Graded &student);

/// Without the sentences that tell to type `./course …`.
std::string without_commands(const std::string &text);

} // namespace course
