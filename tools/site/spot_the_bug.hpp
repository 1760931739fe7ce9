#pragma once
// Which of these two is wrong? The same demo twice in a chapter's page, and one of them plays a bug of tests/bugs.txt.

#include "base/workspace.hpp"
#include "check/bugs.hpp"
#include "site/demos.hpp"

#include <string>
#include <string_view>

namespace course {

/// What marks the place in a chapter, on a separate line; a forge shows nothing there.
inline constexpr std::string_view suspects_mark = "<!-- which is wrong -->";

/// Where a section's demo shows a bug: as it begins at the exercise with the reader's code, or as the bug says.
DemoMark place_of_bug(const Workspace &workspace, const Section &section, const Bug &bug);

/// Both demos, and the questions which it is and why, for docs/play.js. "" if the section shows no bug, or if this edition
/// of the course has no answers.
std::string spot_the_bug(const Workspace &workspace, const Demo &demo);

} // namespace course
