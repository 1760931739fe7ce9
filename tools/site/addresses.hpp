#pragma once
// Which files of the course are pages of the site, and what each is called there.

#include "base/workspace.hpp"
#include "site/book_parts.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// What a page is called, without ".html": "index" for book.md, "chapter_07_segment_intersection", "readme";
/// "source_chapters_course_hpp" for code.
std::string page_name(const Workspace &workspace, const std::filesystem::path &file);

/// The course's files as they are when this is made: every link asks for them.
struct Addresses {
    explicit Addresses(const Workspace &tree_);

    /// Where a link of a Markdown file leads within the site: "errata.html", or "plots/room.svg" for a picture.
    /// A link into the web or within the page stays what it is. Nothing if it leads to what the site does not have.
    std::optional<std::string> of(const std::filesystem::path &file, const std::string &url) const;

    const Workspace &workspace;
    std::vector<BookPart> parts; ///< of book.md

    /// The Markdown files that become pages, besides book.md: the chapters in their order, then what else lies beside
    /// book.md (README.md, ...).
    std::vector<std::filesystem::path> markdown;

    /// The code that has pages too: what the sections share, and each section's header, program,
    /// solution, tests and scripts of figures.
    std::vector<std::filesystem::path> code;
};

} // namespace course
