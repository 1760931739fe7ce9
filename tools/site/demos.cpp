#include "site/demos.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/html.hpp"
#include "book/markdown.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

std::string demo_file(const Section &section) { return "demos/" + section.name + ".js"; }

std::string demo_picture_file(const Demo &demo, const DemoMark &mark) {
    const auto start = std::ranges::find(demo.starts, mark.start);
    return demo_picture_file(demo.section, start == demo.starts.end() ? 0 : std::size_t(start - demo.starts.begin()));
}

namespace {

/// The exercise whose scene a chapter is shown by, where that isn't its opening.
constexpr std::pair<int, std::string_view> shown_by[] = {
    {1, "(1.3)"}, {8, "(8.3)"}, {9, "(9.2)"}, {10, "(10.4)"}, {12, "(12.4)"}};

/// @param marks  all of the chapter, one at least
const DemoMark &best_of(const Section &section, const std::vector<DemoMark> &marks) {
    const auto exercise = std::ranges::find(shown_by, section.number(), &std::pair<int, std::string_view>::first);
    if (exercise == std::end(shown_by)) return marks.front();
    const auto best =
        std::ranges::find_if(marks, [&](const DemoMark &mark) { return contains(mark.start, exercise->second); });
    return best == marks.end() ? marks.front() : *best;
}

} // namespace

std::vector<Demo> demos(const Workspace &workspace) {
    std::vector<Demo> all;
    for (const Section &section : workspace.sections()) {
        if (!fs::exists(workspace.root / demo_file(section))) continue;
        const std::vector<DemoMark> marks = demo_marks(read_file(workspace.chapter(section)));
        if (marks.empty()) continue;
        all.push_back({section, best_of(section, marks), demo_starts(marks),
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
                  : "<img src=\"" + demo_picture_file(demo, mark) + "\" alt=\""
                        + escaped(words_of(parse_markdown(picture_words(demo.about, mark)).get())) + "\">")
           + "<p class=\"without-js\">Here is a demo to play with, for a browser with JavaScript.</p></figure>\n";
}

} // namespace course
