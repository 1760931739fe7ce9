#include "site/demos.hpp"

#include "book/contents.hpp"
#include "book/links.hpp"
#include "book/markdown.hpp"
#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/card.hpp"
#include "site/html.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

std::string demo_file(const Section &section) { return "demos/" + section.name + ".js"; }

namespace {

/// The picture of the demo as it begins at this place, or else of its first.
std::string picture_for(const Demo &demo, const DemoMark &mark) {
    const auto start = std::ranges::find(demo.starts, mark.start);
    return demo_picture_file(demo.section, start == demo.starts.end() ? 0 : std::size_t(start - demo.starts.begin()));
}

} // namespace

std::vector<Demo> demos(const Tree &tree) {
    std::vector<Demo> all;
    for (const Section &section : tree.sections()) {
        if (!fs::exists(tree.root / demo_file(section))) continue;
        const std::vector<DemoMark> marks = demo_marks(read_file(tree.chapter(section)));
        if (marks.empty()) continue;
        all.push_back({section, marks.front(), demo_starts(marks),
                       without_entities(picture_title(tree.root / demo_picture_file(section)))});
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

std::string play_page(const Tree &tree) {
    const std::vector<Demo> all = demos(tree);
    if (all.empty()) return "";
    const std::vector<Entry> rows = contents(read_file(tree.root / "book.md"));
    std::vector<Card> shelf;
    std::string demos;
    for (const Demo &demo : all) {
        const auto row = std::ranges::find(rows, demo.section.number(), &Entry::number);
        const std::string number = demo.section.short_number();
        const std::string title = row == rows.end() ? demo.section.slug() : row->title;
        const std::string words = number + ' ' + title;
        shelf.push_back({.address = '#' + anchor_of(words),
                         .picture = demo.about.empty() ? "" : demo_picture_file(demo.section),
                         .number = number,
                         .title = title,
                         .about = demo.about,
                         .foot = ""});
        demos += "\n## " + words + "\n\n<!-- demo: " + demo.mark.name + " | " + demo.mark.task
                 + " -->\n\nIts code is yours to write in [section " + number + "](chapters/" + demo.section.name
                 + "/README.md)" + (row == rows.end() || row->about.empty() ? "" : ": " + row->about) + ".\n";
    }
    return "# Play\n\n*All demos of the book in one place. Each runs on code that you will write in its chapter.*\n\n"
           + in_a_row(shelf) + '\n' + demos;
}

} // namespace course
