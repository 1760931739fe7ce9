#pragma once
#include "grade/graded.hpp"

#include <string>

namespace course {

/// What one student reads, as plain text: points, what isn't right and why. Nothing in it is about anybody else, or about
/// the machine that judged. It sends nobody to a command that a platform doesn't have, but to `update`, who has a
/// handout.
/// @param whole  every failing test, instead of the first of each exercise
std::string feedback(const GradedClass &graded, const Graded &student, bool whole);

/// The same in parts: what stands above the exercises, and what's said of one of them.
std::string feedback_head(const GradedClass &graded, const Graded &student);
std::string feedback_of(const GradedClass &graded, const GradedExercise &exercise, bool whole);

/// The same in one line, for a gradebook's column of comments.
std::string comment(const Graded &student);

/// Without the sentences that tell to type `./course …`.
std::string without_commands(const std::string &text);

} // namespace course
