#pragma once
#include "base/workspace.hpp"

#include <string>

namespace course {

/// The front page, as Markdown: docs/front.md with what the contents of book.md say about each section.
std::string front_page(const Workspace &workspace);

/// The page with all demos, as Markdown; "" if there are none.
std::string play_page(const Workspace &workspace);

} // namespace course
