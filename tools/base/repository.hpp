#pragma once
// What is made of the course as it's committed: a release, a handout.

#include "base/workspace.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// As `course --version` says it.
/// @throws UserError if CMakeLists.txt doesn't say it
std::string version_of(const Workspace &workspace);

/// Where the book is published to write in, as CMakeLists.txt has it: "https://…", or nothing.
std::string address_of(const Workspace &workspace);

/// What a program prints that is run in this folder.
/// @throws UserError if it fails
std::string printed_by(const std::vector<std::string> &command, const std::filesystem::path &folder);

/// Packs these files and folders of a folder.
void pack(const std::filesystem::path &zip, const std::filesystem::path &folder, const std::vector<std::string> &names);

/// "dist/x.zip, 4.7 MB", a line
std::string with_size(const std::string &name, const std::filesystem::path &file);

/// What git prints in this repository, by nobody in particular.
/// @throws UserError with git's first line, if it fails
std::string git_in(const std::filesystem::path &repository, std::vector<std::string> words);

/// @throws UserError if something isn't committed; `what` is made of what is: "a release"
void require_committed(const Workspace &workspace, const std::string &what);

} // namespace course
