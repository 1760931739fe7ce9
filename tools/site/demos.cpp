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

namespace {

/// @param attributes   what the page's script reads of the place, each with a blank before it
/// @param task         as HTML
/// @param picture,words  the still picture, and what it shows, as text; "" for none
std::string figure(const std::string &id, const std::string &attributes, const std::string &task,
                   const std::string &picture, const std::string &words) {
    return "<figure class=\"play\" id=\"" + id + '"' + attributes + "><figcaption>" + task + "</figcaption>"
           + (words.empty() ? "" : "<img src=\"" + picture + "\" alt=\"" + escaped(words) + "\">")
           + "<p class=\"without-js\">Here is a demo to play with, for a browser with JavaScript.</p></figure>\n";
}
std::string attribute(const std::string &name, const std::string &value) {
    return ' ' + name + "=\"" + escaped(value) + '"';
}

} // namespace

std::string demo_figure(const Demo &demo, const std::string &id, const DemoMark &mark, const std::string &task) {
    return figure(id,
                  attribute("data-demo", demo.section.name)
                      + (mark.exercise.empty() ? "" : attribute("data-exercise", mark.exercise))
                      + (mark.mine ? " data-mine" : "")
                      + (mark.start.empty() ? "" : attribute("data-start", mark.start)),
                  task, demo.about.empty() ? "" : demo_picture_file(demo, mark),
                  demo.about.empty() ? "" : words_of(parse_markdown(picture_words(demo.about, mark)).get()));
}

std::vector<GallerySketch> gallery(const Workspace &workspace) {
    std::vector<GallerySketch> all;
    for (const fs::path &file : files_in(workspace.root / "docs" / "gallery", ".cpp"))
        all.push_back({file.stem(), file, "sketch_" + file.stem().string()});
    return all;
}

std::vector<GallerySketch> published_gallery(const Workspace &workspace) {
    std::vector<GallerySketch> all = gallery(workspace);
    std::erase_if(all, [&](const GallerySketch &each) { return !fs::exists(workspace.root / each.script()); });
    return all;
}

std::string sketch_figure(const Workspace &workspace, const GallerySketch &sketch) {
    const std::string about = without_entities(picture_title(workspace.root / sketch.picture()));
    return figure(sketch.demo, attribute("data-demo", sketch.demo), escaped(about), sketch.picture(), about);
}

} // namespace course
