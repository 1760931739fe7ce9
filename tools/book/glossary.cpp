#include "book/glossary.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "book/links.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace course {
namespace {

/// Words, code and formulas of a node, as Markdown without emphasis.
/// @param next  the first formula of the node; afterwards, the first one below it
std::string markdown_of(cmark_node *root, const std::vector<Formula> &formulas, std::size_t &next) {
    std::string out;
    each_node(root, [&](cmark_node *node) {
        const cmark_node_type type = cmark_node_get_type(node);
        if (type == CMARK_NODE_SOFTBREAK) out += ' ';
        if (type == CMARK_NODE_CODE) out += '`' + literal(node) + '`';
        if (type != CMARK_NODE_TEXT) return;
        std::string text = literal(node);
        for (std::size_t at = 0; (at = text.find(WithoutFormulas::stand_in, at)) != text.npos;) {
            const std::string tex = '$' + formulas.at(next++).tex + '$';
            text.replace(at, WithoutFormulas::stand_in.size(), tex);
            at += tex.size();
        }
        out += text;
    });
    replace_all(out, "|", "\\|"); // for a cell of a table
    return out;
}

bool is_term(std::string_view bold) {
    return !bold.empty() && std::string_view{".!?:;,"}.find(bold.back()) == bold.npos && !bold.ends_with("…");
}

bool is_in_heading_or_box(cmark_node *node) {
    for (; node; node = cmark_node_parent(node))
        if (cmark_node_get_type(node) == CMARK_NODE_HEADING || cmark_node_get_type(node) == CMARK_NODE_BLOCK_QUOTE)
            return true;
    return false;
}

/// `the first`, `second` of `<!-- also: the first, second -->`, if that follows.
std::vector<std::string> also_called(cmark_node *bold) {
    cmark_node *node = cmark_node_next(bold);
    if (node && trim(literal(node)).empty()) node = cmark_node_next(node);
    const std::string comment = node ? literal(node) : "";
    const auto inside = between(comment, "<!-- also: ", " -->");
    std::vector<std::string> names;
    std::istringstream list{std::string{inside.value_or("")}};
    for (std::string name; std::getline(list >> std::ws, name, ',');) names.push_back(name);
    return names;
}

/// One row for each name, from all chapters that have it.
std::vector<std::string> rows_of(const std::vector<Term> &terms) {
    struct Entry {
        std::string name;
        std::vector<std::string> also_called;
        std::string where;
    };
    std::map<std::string, Entry> entries; // sorted whatever the case of the first letter
    for (const Term &term : terms) {
        Entry &entry = entries.try_emplace(lower(term.name), Entry{term.name, {}, ""}).first->second;
        for (const std::string &name : term.also_called)
            if (std::ranges::find(entry.also_called, name) == entry.also_called.end())
                entry.also_called.push_back(name);
        entry.where += (entry.where.empty() ? "[" : ", [") + std::to_string(term.section) + "](" + term.link + ')';
    }
    std::vector<std::string> rows;
    for (const auto &[key, entry] : entries) {
        std::string row = "| " + entry.name + " |";
        for (const std::string &name : entry.also_called)
            row += (&name == &entry.also_called.front() ? " " : ", ") + name;
        rows.push_back(row + " | " + entry.where + " |");
    }
    return rows;
}

/// Where the glossary is in book.md, as lines from 1.
struct Place {
    int heading = 0;        ///< 0 if there is none
    int table = 0, end = 0; ///< first and last line of the table; 0 without one
    int behind = 0;         ///< the line of the next heading, or that behind the last line
};

Place place_in(std::string_view book) {
    Place place;
    const Document document = parse_markdown(book);
    for (cmark_node *node = cmark_node_first_child(document.get()); node; node = cmark_node_next(node)) {
        const int line = cmark_node_get_start_line(node);
        if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
            if (place.heading != 0) {
                place.behind = line;
                return place;
            }
            if (words_of(node) == "Glossary") place.heading = line;
        } else if (place.heading != 0 && is_table(node)) {
            place.table = line;
            place.end = cmark_node_get_end_line(node);
        }
    }
    place.behind = static_cast<int>(split_lines(book).size()) + 1;
    return place;
}

} // namespace

std::vector<Term> terms_of(std::string_view chapter, int section, const std::string &link,
                           const std::filesystem::path &file) {
    const WithoutFormulas taken = take_out_formulas(chapter.substr(byte_order_mark(chapter).size()));
    const Document document = parse_markdown(taken.text);
    cmark_consolidate_text_nodes(document.get());
    std::vector<Term> terms;
    Anchors anchors;
    std::string place = link;
    std::size_t formula = 0;
    each_node(document.get(), [&](cmark_node *node) {
        if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
            const std::string anchor = anchors.next(words_of(node));
            const bool in_a_box = cmark_node_get_type(cmark_node_parent(node)) != CMARK_NODE_DOCUMENT;
            if (!in_a_box && cmark_node_get_heading_level(node) > 1) place = link + '#' + anchor;
        } else if (cmark_node_get_type(node) == CMARK_NODE_STRONG && !is_in_heading_or_box(node)) {
            std::size_t next = formula;
            const std::string name = markdown_of(node, taken.formulas, next);
            if (is_term(name))
                terms.push_back({name, also_called(node), section, place, file, cmark_node_get_start_line(node)});
        } else if (cmark_node_get_type(node) == CMARK_NODE_TEXT) {
            static_cast<void>(markdown_of(node, taken.formulas, formula));
        }
    });
    return terms;
}

std::vector<Term> terms_of(const Workspace &workspace) {
    std::vector<Term> terms;
    for (const Section &section : workspace.sections()) {
        const std::filesystem::path file = workspace.chapter(section);
        for (Term &term : terms_of(read_file(file), section.number(), workspace.relative_name(file), file))
            terms.push_back(std::move(term));
    }
    return terms;
}

Glossary weave_glossary(const std::string &book, const std::filesystem::path &file, const std::vector<Term> &terms) {
    Glossary result{book, {}};
    std::map<std::pair<std::string, std::string>, int> seen; // by chapter and name
    std::vector<Term> once;
    for (const Term &term : terms) {
        const auto [first, is_new] = seen.try_emplace({term.file.string(), lower(term.name)}, term.line);
        if (is_new) once.push_back(term);
        else
            result.findings.push_back({term.file, term.line,
                                       "\"" + term.name + "\" is bold in line " + std::to_string(first->second)
                                           + " already; make it bold only once, where it is explained."});
    }

    const Place place = place_in(std::string_view{book}.substr(byte_order_mark(book).size()));
    if (place.heading == 0) {
        if (!terms.empty())
            result.findings.push_back({file, 1,
                                       "there is no glossary; write a heading `## Glossary`, and ./course "
                                       "weave fills it."});
        return result;
    }
    const std::vector<std::string> rows = rows_of(once);
    std::vector<std::string> table;
    if (!rows.empty()) table = {"| term | also called | where |", "|:--|:--|:--|"};
    table.insert(table.end(), rows.begin(), rows.end());

    // The table comes in the place of the one that is there, or below what stands under the heading.
    std::vector<std::string> lines = with_line_ends(book);
    const std::string end{split_lines(lines[static_cast<std::size_t>(place.heading) - 1]).front().end};
    auto at = lines.begin() + (place.table == 0 ? place.behind : place.table) - 1;
    if (place.table != 0) at = lines.erase(at, lines.begin() + place.end);
    else {
        while (at[-1].find_first_not_of(" \t\r\n") == std::string::npos) --at;
        if (!table.empty()) table.insert(table.begin(), "");
    }
    for (std::string &row : table) row += end;
    lines.insert(at, table.begin(), table.end());
    result.book = joined(lines);
    return result;
}

} // namespace course
