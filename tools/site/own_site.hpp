#pragma once
// The student's own site, beside the plain one and never published: figures with their curve over ours, and demos that
// begin with their code. What cannot be built of it stays ours.

#include "ground/tree.hpp"

#include <string>

namespace course {

/// Whether this machine can compile for pages: cmake/Play.cmake says so.
bool can_compile_demos(const Tree &tree);

/// Compiles the student's file into the section's demo, for the own site: a demo that is open takes it up.
/// The caller holds the Lock.
/// @return what is wrong with the file, in the words of `course check`, as the demo says it, too; "" if nothing is
/// @throws Complaint if the file is not there
std::string build_own_demo(const Tree &tree, const Section &section);

/// Brings up to date what is the student's in a section: its figures, and its demo where it can be compiled.
/// The caller holds the Lock.
/// @return what that is, or why all stays ours, in one sentence without its full stop
std::string renew_own_section(const Tree &tree, const Section &section);

/// Makes the pages of the own site from those of the site, which must be there.
void copy_own_site(const Tree &tree);

} // namespace course
