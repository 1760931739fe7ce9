#pragma once
// From portable Markdown, as a forge shows it, to the body of a page.

#include "site/addresses.hpp"
#include "site/page.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// A page of Markdown. A listing that is a chunk of a file is headed by its title, and by file and line.
/// @param file  where the text is from: links are seen from there
/// @param name  of the page, without ".html"
/// @throws Complaint naming the line of what cannot be shown.
SitePage written_page(const Addresses &addresses, const std::filesystem::path &file, std::string_view text,
                      const std::string &name);

/// A code file as a page of its own.
SitePage source_page(const Tree &tree, const std::filesystem::path &file);

} // namespace course
