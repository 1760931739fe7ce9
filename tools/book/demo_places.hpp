#pragma once
// Where a chapter has its demo, a forge shows a still picture of it, and says how to play it.

#include "book/chapter.hpp"
#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The ways in which the demo begins at its places, each once, in the order of the chapter: there is a picture of each.
std::vector<std::string> demo_starts(const std::vector<DemoMark> &marks);

/// Where a chapter's demo is opened. For an exercise: at the first place below its box, or else below a later box. For
/// a section: at its first place. For the reader's code: at the first such place that begins with it.
/// @param marks  all of the chapter, one at least
std::size_t place_for(const std::vector<DemoMark> &marks, const std::string &exercise, bool mine);

/// Where the picture of the first start is kept, "demos/07_segment_intersection.svg", or of a later one, "..._2.svg".
std::string demo_picture_file(const Section &section, std::size_t start = 0);

/// What a picture shows, as its title says, with HTML's entities; "" without that picture.
std::string picture_title(const std::filesystem::path &svg);

/// The same for a reader who cannot see it: what it shows, and the first sentence of what there is to try. Markdown.
std::string picture_words(const std::string &title, const DemoMark &mark);

/// Whether a line of a chapter was woven below a mark: a picture, or a command.
bool stands_for_a_demo(std::string_view line);

/// The chapter with, below each mark, its picture, the first time that the demo begins so, and the command that plays it.
std::string weave_demo_places(const Tree &tree, const Section &section, std::string_view text);

} // namespace course
