#include "site/front.hpp"

#include "book/contents.hpp"
#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"
#include "site/card.hpp"
#include "site/demos.hpp"
#include "site/gaps.hpp"
#include "site/section_map.hpp"

#include <algorithm>

namespace course {
namespace fs = std::filesystem;
namespace {

std::string page_for(const Tree &tree, const Entry &entry) {
    return page_name(tree, tree.root / entry.chapter) + ".html";
}

/// "75 + 155" is 75 minutes for what everybody does.
std::string core_minutes(const Entry &entry) { return entry.minutes.substr(0, entry.minutes.find(" +")); }

std::string begin_link(const Tree &tree, const std::vector<Entry> &entries) {
    const auto first = std::ranges::find_if(entries, [](const Entry &e) { return !e.chapter.empty(); });
    if (first == entries.end()) return "";
    const std::string minutes = core_minutes(*first);
    return "<a class=\"begin\" href=\"" + page_for(tree, *first) + "\">Begin with " + std::to_string(first->number)
           + ' ' + escaped(first->title) + (minutes.empty() ? "" : " <small>" + escaped(minutes) + "&nbsp;min</small>")
           + "</a>" + (demos(tree).empty() ? "" : "\n<a href=\"play.html\">Play all</a>");
}

/// The picture of the section's demo; "" if there is none.
std::string picture_of(const std::vector<Demo> &all, int number) {
    const auto demo = std::ranges::find_if(all, [&](const Demo &d) { return d.section.number() == number; });
    return demo == all.end() || demo->about.empty() ? "" : demo_picture_file(demo->section);
}

Card card_of(const Tree &tree, const Entry &entry, const std::vector<Demo> &all) {
    const std::string number = std::to_string(entry.number);
    return {.address = page_for(tree, entry),
            .picture = picture_of(all, entry.number),
            .number = number,
            .title = entry.title,
            .about = entry.about,
            .foot = (entry.minutes.empty() ? "" : "<span>" + escaped(entry.minutes) + "&nbsp;minutes</span> ")
                    + "<span data-progress=\"" + number + "\"></span>"};
}

std::string sections_of(const Tree &tree, const std::vector<Entry> &entries) {
    const std::vector<Demo> all = demos(tree);
    std::vector<Card> here;
    std::string to_come;
    for (const Entry &entry : entries)
        if (entry.chapter.empty())
            to_come += "<li><span class=\"number\">" + std::to_string(entry.number) + "</span> " + escaped(entry.title)
                       + "</li>\n";
        else here.push_back(card_of(tree, entry, all));
    return in_a_row(here)
           + (to_come.empty() ? "" : "\n<p class=\"coming\">To come</p>\n<ul class=\"coming\">\n" + to_come + "</ul>");
}

} // namespace

std::string front_page(const Tree &tree) {
    const std::vector<Entry> entries = contents(read_file(tree.root / "book.md"));
    return filled(read_file(tree.root / "docs" / "front.md"),
                  {{"begin", begin_link(tree, entries)},
                   {"sections", sections_of(tree, entries)},
                   {"map", section_map(tree, entries)}},
                  "docs/front.md");
}

} // namespace course
