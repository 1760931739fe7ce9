#pragma once
#include "finding.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Links and images of a Markdown file that lead nowhere: to a file that is not there, out of the tree, or to a heading
/// that is not in its file. Addresses on the web are not followed.
/// @throws Complaint if the file cannot be read.
std::vector<Finding> dead_links(const std::filesystem::path &file, const std::filesystem::path &root);

/// What a forge calls a heading in a link: "Which way does a wall face?" is `#which-way-does-a-wall-face`.
std::string anchor_of(std::string_view heading);

} // namespace course
