#pragma once
#include "ground/tree.hpp"

#include <string>

namespace course {

/// The front page, as Markdown: docs/front.md with what the contents of book.md say about each section.
std::string front_page(const Tree &tree);

} // namespace course
