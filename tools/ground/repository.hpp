#pragma once
// What is made of the course as it's committed: a release, a handout.

#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// As `course --version` says it.
/// @throws Complaint if CMakeLists.txt doesn't say it
std::string version_of(const Tree &tree);

/// What a program prints that is run in this folder.
/// @throws Complaint if it fails
std::string printed_by(const std::vector<std::string> &command, const std::filesystem::path &folder);

/// What git prints in this repository, by nobody in particular.
/// @throws Complaint with git's first line, if it fails
std::string git_in(const std::filesystem::path &repository, std::vector<std::string> words);

/// @throws Complaint if something isn't committed; `what` is made of what is: "a release"
void require_committed(const Tree &tree, const std::string &what);

} // namespace course
