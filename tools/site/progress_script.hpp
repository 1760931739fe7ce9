#pragma once
// What the site's pages know of their reader: a small script, written anew whenever an exercise has been judged.

#include "ground/tree.hpp"

#include <string>

namespace course {

/// A script that sets `progress`: for each section its number, its page and its exercises, each with its number, its
/// function and whether it is done; and, once something has been judged, `next`: the exercise to go on with, with its
/// address.
std::string progress_script(const Tree &tree);

/// Writes it beside the pages of the site, and of the student's own site, where they are.
/// Where it cannot be written, the pages stay as they were, with a line on stderr.
void tell_pages(const Tree &tree);

} // namespace course
