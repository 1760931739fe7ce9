#pragma once
// Where a chapter has its demo, a forge shows a still picture, and the command that plays it.

#include "base/workspace.hpp"
#include "book/chapter.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The ways in which a demo begins, each once, in the order of the chapter: there is a picture of each.
std::vector<std::string> demo_starts(const std::vector<DemoMark> &marks);

/// Where a chapter's demo is opened. For an exercise: at the first place below the box, or else below a later one. For
/// a section: at the first place. For the reader's code: at the first such place that begins with it.
/// @param marks  all of the chapter, one at least
std::size_t place_for(const std::vector<DemoMark> &marks, const std::string &exercise, bool mine);

/// Where the picture of the first start is kept, "demos/07_segment_intersection.svg", or of a later one, "..._2.svg".
std::string demo_picture_file(const Section &section, std::size_t start = 0);

/// What a picture shows, as the SVG says in the title, with entities of HTML; "" without that picture.
std::string picture_title(const std::filesystem::path &svg);

/// The same for a reader who cannot see it: what it shows, and the first sentence of what there is to try. Markdown.
std::string picture_words(const std::string &title, const DemoMark &mark);

/// The chapter with, below each mark, a picture, the first time that the demo begins so, and the command that plays it.
std::string weave_demo_places(const Workspace &workspace, const Section &section, std::string_view text);

} // namespace course
