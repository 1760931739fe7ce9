#include "site/page_template.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "book/contents.hpp"
#include "site/demos.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// "75 + 155" as a sentence.
std::string time_for(const std::string &minutes) {
    const auto plus = minutes.find(" + ");
    if (minutes.empty()) return "";
    return escaped(minutes.substr(0, plus)) + " minutes"
           + (plus == minutes.npos ? "" : ", and " + escaped(minutes.substr(plus + 3)) + " for the other exercises");
}

std::string link(const std::string &address, const std::string &html) {
    return "<a href=\"" + address + "\">" + html + "</a>";
}

/// The parts of the page, and what each has in it.
std::string outline(const SitePage &page) {
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

/// What the contents have a line for.
struct Destination {
    std::string page; ///< without ".html"; "" if it is to come
    std::string title;
    std::string number;  ///< of a section: "7"
    std::string minutes; ///< "90 + 150"
    std::string about{}; ///< of a section: "free fall, and orbits"
};

std::string item(const SitePage &page, const Destination &place) {
    const std::string number = place.number.empty() ? "" : "<span class=\"number\">" + place.number + "</span> ";
    if (place.page.empty())
        return "<li class=\"to-come\">" + number + escaped(place.title)
               + " <span class=\"hidden\">(to come)</span></li>\n";
    const bool here = page.name == place.page;
    return "<li><a href=\"" + place.page + ".html\"" + (here ? " aria-current=\"page\"" : "") + ">" + number
           + escaped(place.title) + "</a>" + (here ? outline(page) : "") + "</li>\n";
}

std::string turn(const Destination &to, const std::string &rel, const std::string &word) {
    return "<a rel=\"" + rel + "\" href=\"" + to.page + ".html\"><span>" + word + "</span> "
           + (to.number.empty() ? "" : to.number + " ") + escaped(to.title)
           + (to.minutes.empty() ? "" : " <small>" + escaped(to.minutes) + " minutes</small>") + "</a>\n";
}

class Surroundings {
  public:
    Surroundings(const Addresses &addresses, const std::vector<SitePage> &pages) : workspace{addresses.workspace} {
        for (const BookPart &part : addresses.parts)
            (part.before_contents ? before : after).push_back({part.name, part.title, "", ""});
        for (const Entry &row : contents(read_file(workspace.root / "book.md")))
            rows.push_back({row.chapter.empty() ? "" : page_name(workspace, workspace.root / row.chapter), row.title,
                            std::to_string(row.number), row.minutes, row.about});
        const auto add_interface = [&](const std::string &space, const std::string &title, const std::string &number) {
            for (const SitePage &page : pages)
                if (page.title == space && page.name.starts_with("namespace"))
                    interfaces.push_back({page.name, title, number, ""});
        };
        for (const Section &section : sections) add_interface(section.slug(), section.slug(), section.short_number());
        add_interface("course", "course: what all share", "");
        for (const auto &file : addresses.markdown)
            if (const std::string name = page_name(workspace, file); !name.starts_with("chapter_"))
                others.push_back({name, name == "readme" ? "How to build it" : with_capital(name), "", ""});
        order = {{"index", "Frame by Frame", "", ""}};
        for (const auto *places : {&before, &rows, &after})
            for (const Destination &place : *places)
                if (!place.page.empty()) order.push_back(place);
    }

    std::string around(const SitePage &page) const {
        const bool first = page.name == "index";
        const std::string title = escaped(page.title) + (first ? "" : " · Frame by Frame");
        return fill_template(page_template,
                             {{"title", title},
                              {"about", about(page, title)},
                              {"kind", first ? "front" : page.kind},
                              {"contents", sidebar(page)},
                              {"above", above(page)},
                              {"body", page.html},
                              {"turning", turning(page)},
                              {"demos", demo_scripts(page.html)}},
                             "docs/page.html");
    }

  private:
    /// For a search engine, and for whoever is sent a link: what the page is about, and the picture of its best scene. The
    /// address is a relative one, and so is the base of 404.html, until tools/site/publish_at knows where the site goes.
    std::string about(const SitePage &page, const std::string &title) const {
        std::string words = page.name == "index"
                                ? "You guess, you work it out, you write the C++ function, and you watch it "
                                  "move: a course in game physics that runs."
                                : page.title + ", in a course in game physics that runs.";
        for (const Destination &row : rows)
            if (row.page == page.name)
                words = row.title + ": " + row.about + ". Part of a course in game physics that runs.";
        const auto meta = [](const std::string &name, const std::string &html) {
            return "<meta " + name + " content=\"" + html + "\">\n";
        };
        const std::string picture = picture_of(page);
        return (page.name == "404" ? "<base href=\"404.html\">\n" : "") + meta("name=\"description\"", escaped(words))
               + meta("property=\"og:title\"", title) + meta("property=\"og:description\"", escaped(words))
               + (picture.empty() ? ""
                                  : meta("property=\"og:image\"", fs::path{picture}.replace_extension("png").string()));
    }

    /// The scene that its chapter is shown by, or else the first in it; "" if there is none.
    std::string picture_of(const SitePage &page) const {
        static const std::regex first{R"re(<img src="(demos/\w+\.svg)")re"};
        std::smatch picture;
        if (!std::regex_search(page.html, picture, first)) return "";
        const auto demo = std::ranges::find_if(all_demos, [&](const Demo &each) {
            return page_name(workspace, workspace.chapter(each.section)) == page.name;
        });
        return demo == all_demos.end() ? picture[1].str() : demo_picture_file(*demo, demo->mark);
    }

    /// What the demos of a page need, if it has some.
    std::string demo_scripts(const std::string &body) const {
        std::string scripts;
        for (const Section &section : sections)
            if (contains(body, "data-demo=\"" + section.name + '"'))
                scripts += "<script src=\"" + demo_file(section) + "\"></script>\n";
        for (const GallerySketch &sketch : sketches)
            if (contains(body, "data-demo=\"" + sketch.demo + '"'))
                scripts += "<script src=\"" + sketch.script() + "\"></script>\n";
        if (scripts.empty()) return "";
        for (const std::string name : {"draw", "answers", "play"})
            scripts += "<script src=\"" + name + ".js\"></script>\n";
        return scripts;
    }

    std::string sidebar(const SitePage &page) const {
        std::string html = "<ul>\n" + item(page, order.front());
        if (!all_demos.empty()) html += item(page, {"play", "Play", "", ""});
        const auto add = [&](const std::string &heading, const std::vector<Destination> &places) {
            if (!heading.empty() && !places.empty()) html += "</ul>\n<p>" + heading + "</p>\n<ul>\n";
            for (const Destination &place : places) html += item(page, place);
        };
        add("", before);
        add("Sections", rows);
        add("To look things up", after);
        add("Interfaces", interfaces);
        add("The course", others);
        return html + "</ul>";
    }

    /// Above the title: how long a section takes, or what else the page belongs to.
    std::string above(const SitePage &page) const {
        for (const Destination &row : rows)
            if (row.page == page.name) return time_for(row.minutes);
        const bool is_interface = page.kind == "interface";
        if (!is_interface && page.kind != "source") return "";
        const std::string space = page.title.substr(0, page.title.find("::"));
        for (const Section &section : sections) {
            if (is_interface ? section.slug() != space : !contains(page.name, section.name)) continue;
            return (is_interface ? "Interface of " : "Code of ")
                   + link("chapter_" + section.name + ".html", "section " + section.short_number())
                   + (is_interface
                          ? ", from " + link(page_name(workspace, workspace.header(section)) + ".html", space + ".hpp")
                          : "");
        }
        return is_interface ? "Interface" : "Code";
    }

    /// The page before and the page after, in the order of the book.
    std::string turning(const SitePage &page) const {
        std::string html;
        for (std::size_t i = 1; i < order.size(); ++i) { // the front page says itself where to begin
            if (order[i].page != page.name) continue;
            html = turn(order[i - 1], "prev", "Previous");
            if (i + 1 < order.size()) html += turn(order[i + 1], "next", "Next");
        }
        return html.empty() ? "" : "<nav class=\"turning\" aria-label=\"Previous and next\">\n" + html + "</nav>";
    }

    const Workspace &workspace;
    const std::string page_template = read_file(workspace.root / "docs" / "page.html");
    const std::vector<Section> sections = workspace.sections();
    const std::vector<GallerySketch> sketches = published_gallery(workspace);
    const std::vector<Demo> all_demos = demos(workspace);
    std::vector<Destination> before, rows, after, interfaces, others, order;
};

} // namespace

std::string fill_template(std::string text, const std::map<std::string, std::string> &gaps, const std::string &file) {
    std::string out;
    for (std::size_t at; (at = text.find("{{")) != text.npos;) {
        const std::size_t end = text.find("}}", at);
        const auto gap = gaps.find(text.substr(at + 2, end - at - 2));
        if (end == text.npos || gap == gaps.end())
            throw UserError{file + " has a gap that nothing fills: " + text.substr(at, 20)};
        out += text.substr(0, at) + gap->second;
        text.erase(0, end + 2);
    }
    return out + text;
}

void add_pages(SiteFiles &files, const Addresses &addresses, const std::vector<SitePage> &pages) {
    const Surroundings surroundings{addresses, pages};
    for (const SitePage &page : pages) files[page.name + ".html"] = surroundings.around(page);
}

} // namespace course
