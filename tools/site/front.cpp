#include "site/front.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "book/chunks.hpp"
#include "book/contents.hpp"
#include "book/links.hpp"
#include "check/bugs.hpp"
#include "site/addresses.hpp"
#include "site/demos.hpp"
#include "site/page_template.hpp"
#include "site/section_map.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace course {
namespace fs = std::filesystem;
namespace {

/// What leads to a section or a demo: a picture, a title, a sentence and a line below. All of it is one link.
struct Card {
    std::string address;
    std::string picture; ///< a file; "" for none
    std::string number;  ///< "7"; may be ""
    std::string title;
    std::string about;
    std::string foot; ///< HTML; may be ""
};

std::string as_item(const Card &card) {
    return "<li class=\"card\">" + (card.picture.empty() ? "" : "<img src=\"" + card.picture + "\" alt=\"\">")
           + "<div><a href=\"" + card.address + "\">"
           + (card.number.empty() ? "" : "<span class=\"number\">" + card.number + "</span> ") + escaped(card.title)
           + "</a>" + (card.about.empty() ? "" : "<p>" + escaped(card.about) + "</p>")
           + (card.foot.empty() ? "" : "<p class=\"foot\">" + card.foot + "</p>") + "</div></li>\n";
}

/// Cards side by side, as HTML.
std::string in_a_row(const std::vector<Card> &cards) {
    std::string html = "<ol class=\"cards\">\n";
    for (const Card &card : cards) html += as_item(card);
    return html + "</ol>";
}

std::string page_for(const Workspace &workspace, const Entry &entry) {
    return page_name(workspace, workspace.root / entry.chapter) + ".html";
}

/// "75 + 155" is 75 minutes for what everybody does.
std::string core_minutes(const Entry &entry) { return entry.minutes.substr(0, entry.minutes.find(" +")); }

std::string begin_link(const Workspace &workspace, const std::vector<Entry> &entries) {
    const auto first = std::ranges::find_if(entries, [](const Entry &e) { return !e.chapter.empty(); });
    if (first == entries.end()) return "";
    const std::string minutes = core_minutes(*first);
    return "<a class=\"begin\" href=\"" + page_for(workspace, *first) + "\">Begin with " + std::to_string(first->number)
           + ' ' + escaped(first->title) + (minutes.empty() ? "" : " <small>" + escaped(minutes) + "&nbsp;min</small>")
           + "</a>" + (demos(workspace).empty() ? "" : "\n<a href=\"play.html\">Play all</a>");
}

/// The picture of the section's best scene; "" if there is none.
std::string picture_of(const std::vector<Demo> &all, int number) {
    const auto demo = std::ranges::find_if(all, [&](const Demo &d) { return d.section.number() == number; });
    return demo == all.end() || demo->about.empty() ? "" : demo_picture_file(*demo, demo->mark);
}

/// "Where will it land?", from "# 4 Where will it land?"; the title in the contents, if a chapter has no such line.
std::string question_of(const Workspace &workspace, const Entry &entry) {
    const fs::path chapter = workspace.root / entry.chapter;
    const std::string text = fs::exists(chapter) ? read_file(chapter) : "", first = text.substr(0, text.find('\n')),
                      head = "# " + std::to_string(entry.number) + ' ';
    return first.starts_with(head) ? first.substr(head.size()) : entry.title;
}

Card card_of(const Workspace &workspace, const Entry &entry, const std::vector<Demo> &all) {
    const std::string number = std::to_string(entry.number);
    return {.address = page_for(workspace, entry),
            .picture = picture_of(all, entry.number),
            .number = number,
            .title = question_of(workspace, entry),
            .about = entry.about,
            .foot = "<span>" + escaped(entry.title)
                    + (entry.minutes.empty() ? "" : ", " + escaped(entry.minutes) + "&nbsp;minutes")
                    + "</span> <span data-progress=\"" + number + "\"></span>"};
}

std::string sections_of(const Workspace &workspace, const std::vector<Entry> &entries) {
    const std::vector<Demo> all = demos(workspace);
    std::vector<Card> here;
    std::string to_come;
    for (const Entry &entry : entries)
        if (entry.chapter.empty())
            to_come += "<li><span class=\"number\">" + std::to_string(entry.number) + "</span> " + escaped(entry.title)
                       + "</li>\n";
        else here.push_back(card_of(workspace, entry, all));
    return in_a_row(here)
           + (to_come.empty() ? "" : "\n<p class=\"coming\">To come</p>\n<ul class=\"coming\">\n" + to_come + "</ul>");
}

std::string as_listing(const std::string &code) { return "\n```cpp\n" + code + "```\n\n"; }

/// What answers at each hit of the front page's demo, and a switch that takes away what the exercise's bug lacks.
std::string code_of_demo(const Workspace &workspace) {
    constexpr std::string_view exercise = "8.3", called = "8.3 resolve_collision";
    for (const Section &section : workspace.sections()) {
        if (section.number() != 8 || !workspace.has_answers(section)) continue;
        const auto bugs = bugs_of(workspace, section);
        const auto bug = std::ranges::find(bugs, exercise, &Bug::exercise);
        const auto chunks = cut(workspace.solution(section));
        const auto chunk = std::ranges::find_if(chunks, [&](const Chunk &c) { return contains(c.title, exercise); });
        if (bug == bugs.end() || chunk == chunks.end()) continue;
        const std::string without = code_of(workspace, section, *bug).text;
        std::string code;
        std::size_t taken = 0; // the line, from 0
        for (std::size_t i = 1; i < chunk->lines.size(); ++i) {
            code += chunk->lines[i] + '\n';
            if (!contains(without, chunk->lines[i])) taken = i - 1;
        }
        return fmt::format("<div class=\"behind\" data-of=\"demo-balls\" data-breaks=\"{}\" data-line=\"{}\">\n"
                           "<label hidden><input type=\"checkbox\"> Take the marked line away</label>\n{}</div>",
                           called, taken, as_listing(code));
    }
    return "";
}

/// Without blank lines, and without those that only comment.
std::ptrdiff_t lines_of_code(const std::string &code) {
    return std::ranges::count_if(split_lines(code), [](const Line &line) {
        const std::string_view words = trim(line.text);
        return !words.empty() && !words.starts_with("//");
    });
}

/// The gallery, each with its code.
std::string sketches(const Workspace &workspace) {
    const std::vector<GallerySketch> all = published_gallery(workspace);
    std::string page;
    if (!all.empty())
        page +=
            "\n## Sketches\n\nEach of these is one short file, which calls functions of the course. "
            "[Make something of your own](docs/sketches.md), or begin with one of them: `./course sketch mine --from "
            + all.front().name + "`.\n";
    for (const GallerySketch &sketch : all) {
        const std::string code = read_file(sketch.file);
        page += "\n<div class=\"sketch\">\n" + sketch_figure(workspace, sketch) + "\n<div>\n<p>"
                + std::to_string(lines_of_code(code)) + " lines of code</p>\n" + as_listing(code) + "</div>\n</div>\n";
    }
    return page;
}

} // namespace

std::string front_page(const Workspace &workspace) {
    const std::vector<Entry> entries = contents(read_file(workspace.root / "book.md"));
    return fill_template(read_file(workspace.root / "docs" / "front.md"),
                         {{"begin", begin_link(workspace, entries)},
                          {"sections", sections_of(workspace, entries)},
                          {"code", code_of_demo(workspace)},
                          {"map", section_map(workspace, entries)}},
                         "docs/front.md");
}

std::string play_page(const Workspace &workspace) {
    const std::vector<Demo> all = demos(workspace);
    if (all.empty()) return "";
    const std::vector<Entry> rows = contents(read_file(workspace.root / "book.md"));
    std::string page = "# Play\n\n*A scene of each chapter, and each runs on code that you will write there.*\n";
    for (const Demo &demo : all) {
        const auto row = std::ranges::find(rows, demo.section.number(), &Entry::number);
        const std::string number = demo.section.short_number();
        const std::string title = row == rows.end() ? demo.section.slug() : row->title;
        const DemoMark &best = demo.mark;
        page += "\n## " + number + ' ' + title + "\n\n<!-- demo: " + best.name
                + (best.start.empty() ? "" : ", " + best.start) + " | " + best.task
                + " -->\n\nIts code is yours to write in [section " + number + "](chapters/" + demo.section.name
                + "/README.md)" + (row == rows.end() || row->about.empty() ? "" : ": " + row->about) + ".\n";
    }
    return page + sketches(workspace);
}

} // namespace course
