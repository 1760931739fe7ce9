#pragma once
// Which of these two is wrong? The same demo twice in a chapter's page, and one of them plays a bug of tests/bugs.txt.

#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// What marks the place in a chapter, on a line of its own; a forge shows nothing there.
inline constexpr std::string_view suspects_mark = "<!-- which is wrong -->";

/// Both demos, and the questions which it is and why, for docs/play.js. "" if the chapter keeps no demo, or if the course
/// is one without answers.
std::string suspects(const Tree &tree, const std::filesystem::path &chapter);

} // namespace course
