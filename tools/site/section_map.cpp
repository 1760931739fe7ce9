#include "site/section_map.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "book/prerequisites.hpp"
#include "site/addresses.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <regex>
#include <set>

namespace course {
namespace {

std::string words_of(const Entry &entry) { return std::to_string(entry.number) + ' ' + entry.title; }

std::string quoted(std::string text) {
    replace_all(text, "\\", "\\\\");
    replace_all(text, "\"", "\\\"");
    return '"' + text + '"';
}

/// In one line or in two, broken at the blank that is nearest to the middle.
std::string in_two_lines(std::string words) {
    const auto off_middle = [&](std::size_t at) { return std::max(at, words.size() - at); };
    std::size_t cut = words.npos;
    if (words.size() > 15)
        for (std::size_t at = words.find(' ', 3); at != words.npos; at = words.find(' ', at + 1))
            if (cut == words.npos || off_middle(at) < off_middle(cut)) cut = at;
    if (cut != words.npos) words[cut] = '\n';
    return words;
}

std::string box(const Workspace &workspace, const Entry &entry) {
    std::string lines = quoted(in_two_lines(words_of(entry)));
    replace_all(lines, "\n", "\\n");
    const std::string kind = entry.chapter.empty()
                                 ? "class=\"to-come\""
                                 : "URL=" + quoted(page_name(workspace, workspace.root / entry.chapter) + ".html");
    return fmt::format("{} [label={} {}]\n", entry.number, lines, kind);
}

std::string label_of(const Entry &entry) {
    return escaped(words_of(entry) + (entry.chapter.empty() ? ", to come" : "")
                   + (entry.needs.empty() ? "" : ": needs " + entry.needs));
}

/// For a phone, where the boxes would be too small to read.
std::string list_item(const Workspace &workspace, const Entry &entry) {
    std::string label = label_of(entry);
    const std::string words = escaped(words_of(entry));
    if (!entry.chapter.empty())
        label.replace(0, words.size(),
                      "<a href=\"" + page_name(workspace, workspace.root / entry.chapter) + ".html\">" + words
                          + "</a>");
    return "<li>" + label + "</li>\n";
}

/// The graph in Graphviz's language. A line that another way says already is left out; but a way through what only one
/// exercise needs says nothing of the section.
std::string graph(const Workspace &workspace, const std::vector<Entry> &entries) {
    std::map<int, std::set<int>> before; // all that a section needs as a whole
    std::string boxes, lines;
    for (const Entry &entry : entries) {
        const std::vector<Prerequisite> needed = read_needs(entry.needs);
        std::set<int> implied;
        for (const auto &[section, exercise] : needed)
            if (exercise.empty()) implied.insert(before[section].begin(), before[section].end());
        std::set<int> &all = before[entry.number] = implied;
        for (const auto &[section, exercise] : needed) {
            if (exercise.empty()) all.insert(section);
            if (!implied.contains(section))
                lines +=
                    fmt::format("{} -> {} [{}]\n", section, entry.number, exercise.empty() ? "" : "class=\"in-part\"");
        }
        boxes += box(workspace, entry);
    }
    return "digraph {\nnode [shape=box style=rounded fixedsize=true width=2 height=0.62 fontsize=17]\n"
           "edge [arrowhead=none]\nranksep=0.35 nodesep=0.2 bgcolor=transparent\n"
           + boxes + lines + "}\n";
}

/// Graphviz's picture, as a part of a page.
std::string drawn(const Workspace &workspace, const std::string &graph) {
    const std::filesystem::path file = workspace.build / "map.dot";
    write_file(file, graph);
    const Finished done = run({"dot", "-Tsvg", file.string()}, {.deadline = 60});
    std::smatch size;
    static const std::regex view{R"(viewBox="[^"]*")"};
    if (done.code != 0 || !std::regex_search(done.out, size, view))
        throw UserError{"Graphviz didn't draw the map of the sections:\n" + done.err};
    std::string svg = done.out.substr(done.out.find('>', static_cast<std::size_t>(size.position())) + 1);
    static const std::regex not_for_readers{
        R"(<!--[^>]*-->\n|<title>[^<]*(%|&gt;)[^<]*</title>\n| xlink:title="[^"]*")"};
    svg = std::regex_replace(svg, not_for_readers, "");
    replace_all(svg, "&#45;", "-");
    replace_all(svg, "xlink:href", "href");
    return "<svg class=\"map\" " + size.str() + " role=\"group\" aria-label=\"Which section needs which\">" + svg;
}

} // namespace

std::string section_map(const Workspace &workspace, const std::vector<Entry> &entries) {
    if (std::ranges::all_of(entries, [](const Entry &e) { return e.needs.empty(); })) return "";
    std::string map = drawn(workspace, graph(workspace, entries)), list;
    for (const Entry &entry : entries) {
        replace_all(map, fmt::format("<title>{}</title>", entry.number), "<title>" + label_of(entry) + "</title>");
        list += list_item(workspace, entry);
    }
    return map + "<ul class=\"map-list\">\n" + list + "</ul>";
}

} // namespace course
