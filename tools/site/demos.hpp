#pragma once
// Demos: where a chapter asks for one, and how a page has it.

#include "ground/tree.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A demo, as the first mark of its chapter names it: `<!-- demo: room | Throw the ball, and watch the walls. -->`.
struct Demo {
    std::string name; ///< "room"
    Section section;
    std::string task; ///< what to try, and what to watch: Markdown
};

/// The demos of all chapters, in their order: those of sections whose demo is kept in demos/.
std::vector<Demo> demos(const Tree &tree);

/// The file in which a section's demo is kept, and is read by the site's pages: "demos/07_segment_intersection.js".
std::string demo_file(const Section &section);

/// The same, as the build compiles it where there is a compiler for pages.
inline std::filesystem::path compiled_demo(const Tree &tree, const Section &section) {
    return tree.build / "play" / (section.name + ".js");
}

/// `<!-- demo: NAME | task -->`, `<!-- demo: NAME mine | task -->`: what a mark says.
struct DemoMark {
    std::string name, task;
    bool mine = false; ///< begins with the reader's code, where there is some
};
std::optional<DemoMark> demo_mark(std::string_view html);

/// The demo's place in a page; its task is HTML by now.
std::string demo_figure(const Demo &demo, const std::string &id, const std::string &task, bool mine);

/// The page with all demos, as Markdown; "" if there are none.
std::string play_page(const Tree &tree);

} // namespace course
