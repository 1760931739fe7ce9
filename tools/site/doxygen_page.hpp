#pragma once
// From portable Markdown, as a forge shows it, to what Doxygen 1.9 reads.

#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// The page as Doxygen wants it. Doxygen's own Markdown knows no formulas with `$`, breaks folds, and takes `\dot` or
/// `@word` for commands; so it gets HTML, which it passes on as it is, and between it the listings, in which it colours
/// the words and links what it knows.
///
/// A formula becomes `<span class="math" data-from="chapters/07_.../README.md:12">t</span>` (class "math display"), to
/// be typeset later. A listing that is a chunk of a file is headed by its title, and by file and line.
/// @param file  where the text is from: links are seen from there
/// @param name  of the page, without ".html"
/// @throws Complaint naming the line of what cannot be shown.
std::string doxygen_page(const Tree &tree, const std::filesystem::path &file, std::string_view text,
                         const std::string &name);

/// A code file as a page of its own.
std::string doxygen_source(const Tree &tree, const std::filesystem::path &file, std::string_view code);

} // namespace course
