#pragma once
// What the headers declare, as Doxygen describes it.

#include "site/page_writer.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace course {

/// Functions, types and constants, by namespace and by name without it, as Doxygen's tag file has them:
/// {"wall": {"crossing": {"address": "namespacewall.html#a12", "function": true}}}.
/// @throws UserError if the file cannot be read.
nlohmann::json declared_names(const std::filesystem::path &tag_file);

/// Those of Doxygen's pages in a folder that describe a namespace or a type, without Doxygen's own header and menus.
/// @throws UserError if one is not as expected.
std::vector<SitePage> reference_pages(const std::filesystem::path &folder);

} // namespace course
