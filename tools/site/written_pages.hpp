#pragma once
#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// A page of the site that is written as Markdown.
struct WrittenPage {
    std::string name;           ///< without ".html"
    std::filesystem::path file; ///< which its links are seen from, and its lines counted in
    std::string text;
};

/// The front page, the parts of book.md, the chapters, the other files beside book.md, and the page with all demos.
std::vector<WrittenPage> written_pages(const Tree &tree);

} // namespace course
