#pragma once
#include "book/finding.hpp"

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

/// Whether a link has a scheme, as "https:" or "mailto:".
bool is_on_the_web(std::string_view url);

/// A link's path as a file system has it: "%20" is a blank.
std::string unescaped(std::string_view url);

} // namespace course
