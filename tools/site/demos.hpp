#pragma once
// Demos: where a chapter asks for one, and how a page has it.

#include "book/demo_places.hpp"
#include "ground/tree.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// A demo, as the first mark of its chapter has it.
struct Demo {
    Section section;
    DemoMark mark;
    std::vector<std::string> starts; ///< see demo_starts
    std::string about;               ///< what it shows, as its picture says; "" if there is no picture
};

/// The demos of all chapters, in their order: those of sections whose demo is kept in demos/.
std::vector<Demo> demos(const Tree &tree);

/// The file in which a section's demo is kept, and is read by the site's pages: "demos/07_segment_intersection.js".
std::string demo_file(const Section &section);

/// The same, as the build compiles it where there is a compiler for pages.
inline std::filesystem::path compiled_demo(const Tree &tree, const Section &section) {
    return tree.build / "play" / (section.name + ".js");
}

/// The address of a demo's place within its page, after so many others: "demo-room", "demo-room-2".
std::string demo_id(const DemoMark &mark, std::size_t others_before);

/// The demo's place in a page; its task is HTML by now.
std::string demo_figure(const Demo &demo, const std::string &id, const DemoMark &mark, const std::string &task);

/// The page with all demos, as Markdown; "" if there are none.
std::string play_page(const Tree &tree);

} // namespace course
