#pragma once
// The map of the sections: which of them needs which.

#include "base/workspace.hpp"
#include "book/contents.hpp"

#include <string>
#include <vector>

namespace course {

/// The map as an SVG for the site's pages, in their colours; a section that stands is a link. "" if none needs another.
std::string section_map(const Workspace &workspace, const std::vector<Entry> &entries);

} // namespace course
