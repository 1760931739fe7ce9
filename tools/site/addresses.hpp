#pragma once
// Which files of the course are pages of its site, and what each is called there.

#include "ground/tree.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The Markdown files that become pages: book.md first, then the chapters in their order, then what else lies beside
/// book.md (README.md, ...).
std::vector<std::filesystem::path> markdown_pages(const Tree &tree);

/// The code that is shown as pages of its own: what the sections share, and each section's header, program, solution,
/// tests and scripts of figures.
std::vector<std::filesystem::path> source_pages(const Tree &tree);

/// What a page is called, without ".html": "index" for book.md, "chapter_07_segment_intersection", "readme";
/// "source_chapters_course_hpp" for code.
std::string page_name(const Tree &tree, const std::filesystem::path &file);

/// Where a link of a Markdown file leads within the site: "errata.html", or "plots/room.svg" for a picture.
/// A link into the web or within the page stays what it is. Nothing if it leads to what the site does not have.
std::optional<std::string> address(const Tree &tree, const std::filesystem::path &file, const std::string &url);

} // namespace course
