#pragma once
// The edition of the course without solutions, for instructors who hand it out.

#include "base/workspace.hpp"
#include "book/finding.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Makes a handout of a copy of the course: takes out of this folder what gives answers away, or is of no use without them.
void make_handout(const std::filesystem::path &folder);

/// A page of the course as it stands in a handout: without the bars of our solutions, and without what isn't there.
/// @param file  its path in the course, with slashes
std::string page_in_handout(const std::string &file, std::string page);

/// What a handout must not say: in some place of this folder, a telling line of our solutions, or a link to what isn't there.
/// @param workspace  the whole course
std::vector<Finding> leaks(const Workspace &workspace, const std::filesystem::path &folder);

} // namespace course
