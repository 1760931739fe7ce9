#pragma once
#include "base/workspace.hpp"
#include "site/link_check.hpp"

#include <filesystem>
#include <string>

namespace course {

/// What the site is made with, besides this program.
struct SiteTools {
    std::string doxygen, node;   ///< programs
    std::filesystem::path katex; ///< the folder of katex.js, katex.min.css and fonts/
    std::filesystem::path lunr;  ///< the file lunr.js
};

/// Where the site is.
inline std::filesystem::path site_folder(const Workspace &workspace) { return workspace.build / "site"; }

/// Where the student's own site is, which `./course site --mine` makes of it.
inline std::filesystem::path own_site_folder(const Workspace &workspace) { return workspace.build / "mine" / "site"; }

/// Makes the whole site anew; files that stay the same keep their date.
/// @throws UserError naming what is wrong and where: a formula that cannot be read, a warning of Doxygen's, a dead link.
void build_site(const Workspace &workspace, const SiteTools &tools);

/// Writes what has changed of a site, and removes what is no longer a part of it.
void write_site(const std::filesystem::path &folder, const SiteFiles &files);

} // namespace course
