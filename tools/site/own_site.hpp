#pragma once
// The student's own site, beside the plain one and never published: figures with their curve over ours, and demos that
// begin with their code. What cannot be built of it stays ours.

#include "base/workspace.hpp"

#include <string>

namespace course {

/// Whether this machine can compile for pages: cmake/Play.cmake says so.
bool can_compile_demos(const Workspace &workspace);

/// Compiles the student's file into the section's demo, for the own site: a demo that is open takes it up.
/// The caller holds the Lock.
/// @return what is wrong with the file, in the words of `course check`, as the demo says it, too; "" if nothing is
/// @throws UserError if the file is not there
std::string build_own_demo(const Workspace &workspace, const Section &section);

/// Brings up to date what is the student's in a section: figures, and the demo where it can be compiled.
/// The caller holds the Lock.
/// @return what that is, or why all stays ours, in one sentence without the full stop
std::string renew_own_section(const Workspace &workspace, const Section &section);

/// Makes the pages of the own site from those of the site, which must be there.
void copy_own_site(const Workspace &workspace);

} // namespace course
