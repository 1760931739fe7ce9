#include "site/page_template.hpp"

#include "book/contents.hpp"
#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"
#include "site/demos.hpp"
#include "site/gaps.hpp"

#include <regex>

namespace course {
namespace {

/// "75 + 155" as a sentence of its own.
std::string time_for(const std::string &minutes) {
    const auto plus = minutes.find(" + ");
    if (minutes.empty()) return "";
    return escaped(minutes.substr(0, plus)) + " minutes"
           + (plus == minutes.npos ? "" : ", and " + escaped(minutes.substr(plus + 3)) + " for the other exercises");
}

std::string link(const std::string &address, const std::string &html) {
    return "<a href=\"" + address + "\">" + html + "</a>";
}

} // namespace

PageTemplate::PageTemplate(const Tree &tree_, const std::map<std::string, Interface> &known_, std::string page)
    : tree{tree_},
      known{known_},
      page_template{std::move(page)},
      sections{tree.sections()},
      has_demos{!demos(tree).empty()} {
    const std::string book = read_file(tree.root / "book.md");
    book_pages = book_parts(book);
    for (const auto &row : contents(book))
        entries.push_back({std::to_string(row.number), row.title, row.minutes,
                           row.chapter.empty() ? "" : page_name(tree, tree.root / row.chapter)});
    for (const auto &file : markdown_pages(tree))
        if (const std::string name = page_name(tree, file); name != "index" && !name.starts_with("chapter_"))
            others.emplace_back(name, name == "readme" ? "How to build it" : with_capital(name));
}

std::string PageTemplate::around(const Draft &draft, const std::string &body) const {
    const bool first = draft.name() == "index";
    return filled(page_template,
                  {{"title", escaped(draft.title()) + (first ? "" : " · Frame by Frame")},
                   {"kind", first                                 ? "front"
                            : draft.is_interface()                ? "interface"
                            : draft.name().starts_with("source_") ? "source"
                                                                  : "chapter"},
                   {"contents", sidebar(draft)},
                   {"above", above(draft)},
                   {"body", body},
                   {"turning", turning(draft)},
                   {"demos", demo_scripts(body)}},
                  "docs/page.html");
}

/// What the demos of a page need, if it has some.
std::string PageTemplate::demo_scripts(const std::string &body) const {
    std::string scripts;
    for (const Section &section : sections)
        if (body.find("data-demo=\"" + section.name + '"') != std::string::npos)
            scripts += "<script src=\"" + demo_file(section) + "\"></script>\n";
    return scripts.empty() ? "" : scripts + "<script src=\"play.js\"></script>\n";
}

const Section *PageTemplate::section_of(const std::string &name) const {
    for (const Section &section : sections)
        if (name.find(section.name) != std::string::npos) return &section;
    return nullptr;
}

std::string PageTemplate::item(const Draft &draft, const std::string &page, const std::string &words,
                               const std::string &number) const {
    const bool here = draft.name() + ".html" == page;
    return "<li><a href=\"" + page + "\"" + (here ? " aria-current=\"page\"" : "") + ">"
           + (number.empty() ? "" : "<span class=\"number\">" + number + "</span> ") + escaped(words) + "</a>"
           + (here ? outline(draft) : "") + "</li>\n";
}

/// The parts of the page, below its entry, and what each has in it.
std::string PageTemplate::outline(const Draft &draft) const {
    static const std::regex minutes{R"( \(\d+ minutes?\)$)"};
    std::string parts, inside;
    const auto end_part = [&] {
        if (!parts.empty()) parts += (inside.empty() ? "" : "\n<ul>\n" + inside + "</ul>") + "</li>\n";
        inside.clear();
    };
    for (const Heading &heading : draft.headings()) {
        const std::string entry =
            "<li>" + link("#" + escaped(heading.id), escaped(std::regex_replace(heading.words, minutes, "")));
        if (heading.level == 2) {
            end_part();
            parts += entry;
        } else if (heading.level == 3 && !parts.empty()) inside += entry + "</li>\n";
    }
    end_part();
    return parts.empty() ? "" : "\n<ul class=\"parts\">\n" + parts + "</ul>";
}

/// The parts of book.md before its sections, or those after them.
std::string PageTemplate::part_items(const Draft &draft, bool before) const {
    std::string items;
    for (const BookPart &part : book_pages)
        if (part.before_contents == before) items += item(draft, part.name + ".html", part.title);
    return items;
}

std::string PageTemplate::sidebar(const Draft &draft) const {
    std::string html = "<ul>\n" + item(draft, "index.html", "Frame by Frame")
                       + (has_demos ? item(draft, "play.html", "Play") : "") + part_items(draft, true)
                       + "</ul>\n<p>Sections</p>\n<ul>\n";
    for (const Entry &entry : entries)
        html += entry.page.empty() ? "<li class=\"to-come\"><span class=\"number\">" + entry.number + "</span> "
                                         + escaped(entry.title) + " <span class=\"hidden\">(to come)</span></li>\n"
                                   : item(draft, entry.page + ".html", entry.title, entry.number);
    if (const std::string more = part_items(draft, false); !more.empty())
        html += "</ul>\n<p>To look things up</p>\n<ul>\n" + more;
    html += "</ul>\n<p>Interfaces</p>\n<ul>\n";
    for (const Section &section : sections)
        if (const auto found = known.find(section.slug()); found != known.end() && !found->second.page.empty())
            html += item(draft, found->second.page, section.slug(), section.short_number());
    if (const auto shared = known.find("course"); shared != known.end() && !shared->second.page.empty())
        html += item(draft, shared->second.page, "course: what all share");
    html += "</ul>\n<p>The course</p>\n<ul>\n";
    for (const auto &[page, title] : others) html += item(draft, page + ".html", title);
    return html + "</ul>";
}

/// Above the title: how long a section takes, or what else the page belongs to.
std::string PageTemplate::above(const Draft &draft) const {
    for (const Entry &entry : entries)
        if (entry.page == draft.name()) return time_for(entry.minutes);
    if (draft.is_interface()) {
        const std::string space = draft.title().substr(0, draft.title().find("::"));
        for (const Section &section : sections)
            if (section.slug() == space)
                return "Interface of " + link("chapter_" + section.name + ".html", "section " + section.short_number())
                       + ", from " + link(page_name(tree, tree.header(section)) + ".html", section.slug() + ".hpp");
        return "Interface";
    }
    if (draft.name().starts_with("source_")) {
        const Section *section = section_of(draft.name());
        return section ? "Code of " + link("chapter_" + section->name + ".html", "section " + section->short_number())
                       : "Code";
    }
    return "";
}

/// The page before and the page after, in the order of the book.
std::string PageTemplate::turning(const Draft &draft) const {
    if (draft.name() == "index") return ""; // which says where to begin
    std::vector<Entry> order{{"", "Frame by Frame", "", "index"}};
    const auto add_parts = [&](bool before) {
        for (const BookPart &part : book_pages)
            if (part.before_contents == before) order.push_back({"", part.title, "", part.name});
    };
    add_parts(true);
    for (const Entry &entry : entries)
        if (!entry.page.empty()) order.push_back(entry);
    add_parts(false);
    const auto turn = [](const Entry &to, const char *rel, const char *word) {
        return "<a rel=\"" + std::string{rel} + "\" href=\"" + to.page + ".html\"><span>" + word + "</span> "
               + (to.number.empty() ? "" : to.number + " ") + escaped(to.title)
               + (to.minutes.empty() ? "" : " <small>" + escaped(to.minutes) + " minutes</small>") + "</a>\n";
    };
    std::string html;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i].page != draft.name()) continue;
        if (i > 0) html += turn(order[i - 1], "prev", "Previous");
        if (i + 1 < order.size()) html += turn(order[i + 1], "next", "Next");
    }
    return html.empty() ? "" : "<nav class=\"turning\" aria-label=\"Previous and next\">\n" + html + "</nav>";
}

} // namespace course
