#pragma once
// A course for many, as in a lab: built by somebody else, and not the student's to write. What's the student's is in a
// folder of their own.

#include "base/process.hpp"
#include "base/workspace.hpp"

namespace course {

/// Makes the student's folder, if it isn't there yet, with empty exercises, and links to all else that the course has.
/// What's in it stays as it is.
/// @return whether it's new
bool create_student_folder(const Workspace &workspace);

/// Brings a target of the build up to date for this student: of the build's own commands, those that read the student's
/// files run again, and so do those that read what these have made. What they make lies in `tree.work()`, by the names that
/// it has in the build folder.
/// @throws EnvironmentError if the build lacks something else that the target needs
Finished build_apart(const Workspace &workspace, const std::string &target);

/// For what takes more room than a student's folder may have.
/// @throws UserError in a course for many
void require_own_course(const Workspace &workspace);

} // namespace course
