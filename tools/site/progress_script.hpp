#pragma once
// What the site's pages know of their reader: a small script, written anew whenever an exercise has been judged.

#include "base/workspace.hpp"

#include <string>

namespace course {

/// A script that sets `progress`: for each section number, page and exercises, each with number, function and
/// whether it is done; and, once something has been judged, `next`: the exercise to go on with, and the address.
std::string progress_script(const Workspace &workspace);

/// Writes it beside the pages of the site, and of the student's own site, where they are.
/// Where it cannot be written, the pages stay as they were, with a line on stderr.
void write_progress_script(const Workspace &workspace);

} // namespace course
