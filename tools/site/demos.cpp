#include "site/demos.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/html.hpp"
#include "book/markdown.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

std::string demo_file(const Section &section) { return "demos/" + section.name + ".js"; }

namespace {

/// The picture of the demo as it begins at this place, or else the first.
std::string picture_for(const Demo &demo, const DemoMark &mark) {
    const auto start = std::ranges::find(demo.starts, mark.start);
    return demo_picture_file(demo.section, start == demo.starts.end() ? 0 : std::size_t(start - demo.starts.begin()));
}

} // namespace

std::vector<Demo> demos(const Workspace &workspace) {
    std::vector<Demo> all;
    for (const Section &section : workspace.sections()) {
        if (!fs::exists(workspace.root / demo_file(section))) continue;
        const std::vector<DemoMark> marks = demo_marks(read_file(workspace.chapter(section)));
        if (marks.empty()) continue;
        all.push_back({section, marks.front(), demo_starts(marks),
                       without_entities(picture_title(workspace.root / demo_picture_file(section)))});
    }
    return all;
}

std::string demo_id(const DemoMark &mark, std::size_t others_before) {
    return "demo-" + mark.name + (others_before > 0 ? '-' + std::to_string(others_before + 1) : "");
}

std::string demo_figure(const Demo &demo, const std::string &id, const DemoMark &mark, const std::string &task) {
    return "<figure class=\"play\" id=\"" + id + "\" data-demo=\"" + demo.section.name + '"'
           + (mark.exercise.empty() ? "" : " data-exercise=\"" + mark.exercise + '"') + (mark.mine ? " data-mine" : "")
           + (mark.start.empty() ? "" : " data-start=\"" + escaped(mark.start) + '"') + "><figcaption>" + task
           + "</figcaption>"
           + (demo.about.empty()
                  ? ""
                  : "<img src=\"" + picture_for(demo, mark) + "\" alt=\""
                        + escaped(words_of(parse_markdown(picture_words(demo.about, mark)).get())) + "\">")
           + "<p class=\"without-js\">Here is a demo to play with, for a browser with JavaScript.</p></figure>\n";
}

} // namespace course
