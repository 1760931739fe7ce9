#pragma once
// What the headers declare, as Doxygen describes it.

#include "site/page.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace course {

/// Functions, types and constants, by namespace and by name without it.
struct Declared {
    std::string address; ///< "namespacewall.html#a12"
    bool is_function = false;
};
using Names = std::map<std::string, std::map<std::string, Declared>>;

/// Reads what Doxygen has written down in its tag file.
/// @throws Complaint if the file cannot be read.
Names declared_names(const std::filesystem::path &tag_file);

/// Those of Doxygen's pages in a folder that describe a namespace or a type, without Doxygen's own header and menus.
/// @throws Complaint if one is not as expected.
std::vector<SitePage> reference_pages(const std::filesystem::path &folder);

} // namespace course
