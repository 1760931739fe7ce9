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

PageTemplate::PageTemplate(const Addresses &addresses, const std::vector<SitePage> &reference, std::string page)
    : tree{addresses.tree},
      book_pages{addresses.parts},
      page_template{std::move(page)},
      sections{tree.sections()},
      has_demos{!demos(tree).empty()} {
    for (const SitePage &each : reference)
        if (each.name.starts_with("namespace")) interfaces[each.title] = each.name + ".html";
    for (const auto &row : contents(read_file(tree.root / "book.md")))
        entries.push_back({std::to_string(row.number), row.title, row.minutes,
                           row.chapter.empty() ? "" : page_name(tree, tree.root / row.chapter)});
    for (const auto &file : addresses.markdown)
        if (const std::string name = page_name(tree, file); !name.starts_with("chapter_"))
            others.emplace_back(name, name == "readme" ? "How to build it" : with_capital(name));
}

std::string PageTemplate::around(const SitePage &page) const {
    const bool first = page.name == "index";
    return filled(page_template,
                  {{"title", escaped(page.title) + (first ? "" : " · Frame by Frame")},
                   {"kind", first ? "front" : page.kind},
                   {"contents", sidebar(page)},
                   {"above", above(page)},
                   {"body", page.html},
                   {"turning", turning(page)},
                   {"demos", demo_scripts(page.html)}},
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

std::string PageTemplate::item(const SitePage &page, const std::string &address, const std::string &words,
                               const std::string &number) const {
    const bool here = page.name + ".html" == address;
    return "<li><a href=\"" + address + "\"" + (here ? " aria-current=\"page\"" : "") + ">"
           + (number.empty() ? "" : "<span class=\"number\">" + number + "</span> ") + escaped(words) + "</a>"
           + (here ? outline(page) : "") + "</li>\n";
}

/// The parts of the page, below its entry, and what each has in it.
std::string PageTemplate::outline(const SitePage &page) const {
    static const std::regex minutes{R"( \(\d+ minutes?\)$)"};
    std::string parts, inside;
    const auto end_part = [&] {
        if (!parts.empty()) parts += (inside.empty() ? "" : "\n<ul>\n" + inside + "</ul>") + "</li>\n";
        inside.clear();
    };
    for (const Heading &heading : page.headings) {
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
std::string PageTemplate::part_items(const SitePage &page, bool before) const {
    std::string items;
    for (const BookPart &part : book_pages)
        if (part.before_contents == before) items += item(page, part.name + ".html", part.title);
    return items;
}

std::string PageTemplate::sidebar(const SitePage &page) const {
    std::string html = "<ul>\n" + item(page, "index.html", "Frame by Frame")
                       + (has_demos ? item(page, "play.html", "Play") : "") + part_items(page, true)
                       + "</ul>\n<p>Sections</p>\n<ul>\n";
    for (const Entry &entry : entries)
        html += entry.page.empty() ? "<li class=\"to-come\"><span class=\"number\">" + entry.number + "</span> "
                                         + escaped(entry.title) + " <span class=\"hidden\">(to come)</span></li>\n"
                                   : item(page, entry.page + ".html", entry.title, entry.number);
    if (const std::string more = part_items(page, false); !more.empty())
        html += "</ul>\n<p>To look things up</p>\n<ul>\n" + more;
    html += "</ul>\n<p>Interfaces</p>\n<ul>\n";
    for (const Section &section : sections)
        if (const auto found = interfaces.find(section.slug()); found != interfaces.end())
            html += item(page, found->second, section.slug(), section.short_number());
    if (const auto shared = interfaces.find("course"); shared != interfaces.end())
        html += item(page, shared->second, "course: what all share");
    html += "</ul>\n<p>The course</p>\n<ul>\n";
    for (const auto &[name, title] : others) html += item(page, name + ".html", title);
    return html + "</ul>";
}

/// Above the title: how long a section takes, or what else the page belongs to.
std::string PageTemplate::above(const SitePage &page) const {
    for (const Entry &entry : entries)
        if (entry.page == page.name) return time_for(entry.minutes);
    if (page.kind == "interface") {
        const std::string space = page.title.substr(0, page.title.find("::"));
        for (const Section &section : sections)
            if (section.slug() == space)
                return "Interface of " + link("chapter_" + section.name + ".html", "section " + section.short_number())
                       + ", from " + link(page_name(tree, tree.header(section)) + ".html", section.slug() + ".hpp");
        return "Interface";
    }
    if (page.kind == "source") {
        const Section *section = section_of(page.name);
        return section ? "Code of " + link("chapter_" + section->name + ".html", "section " + section->short_number())
                       : "Code";
    }
    return "";
}

/// The page before and the page after, in the order of the book.
std::string PageTemplate::turning(const SitePage &page) const {
    if (page.name == "index") return ""; // which says where to begin
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
        if (order[i].page != page.name) continue;
        if (i > 0) html += turn(order[i - 1], "prev", "Previous");
        if (i + 1 < order.size()) html += turn(order[i + 1], "next", "Next");
    }
    return html.empty() ? "" : "<nav class=\"turning\" aria-label=\"Previous and next\">\n" + html + "</nav>";
}

} // namespace course
