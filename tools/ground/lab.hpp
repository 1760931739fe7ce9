#pragma once
// A course for many, as in a lab: built by somebody else, and not the student's to write. What's the student's is in a
// folder of their own.

#include "ground/process.hpp"
#include "ground/tree.hpp"

namespace course {

/// Makes the student's folder, if it isn't there yet, with empty exercises, and links to all else that the course has.
/// What's in it stays as it is.
/// @return whether it's new
bool settle_in(const Tree &tree);

/// Brings a target of the build up to date for this student: of the build's own commands, those that read the student's
/// files run again, and so do those that read what these have made. What they make lies in `tree.work()`, by the names that
/// it has in the build folder.
/// @throws MachineTrouble if the build lacks something else that the target needs
Finished build_apart(const Tree &tree, const std::string &target);

/// For what takes more room than a student's folder may have.
/// @throws Complaint in a course for many
void require_own_course(const Tree &tree);

} // namespace course
