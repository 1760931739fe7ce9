#include "site/book_parts.hpp"

#include "base/lines.hpp"
#include "book/contents.hpp"
#include "book/links.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <cctype>

namespace course {
namespace {

struct BookHeading {
    std::size_t line; ///< from 1
    int level;
    std::string words, anchor;
};

std::vector<BookHeading> book_headings(std::string_view book) {
    const Document document = parse_markdown(book);
    std::vector<BookHeading> headings;
    Anchors anchors;
    each_node(document.get(), [&](cmark_node *node) {
        if (cmark_node_get_type(node) != CMARK_NODE_HEADING) return;
        const std::string words = words_of(node);
        headings.push_back({static_cast<std::size_t>(cmark_node_get_start_line(node)),
                            cmark_node_get_heading_level(node), words, anchors.next(words)});
    });
    return headings;
}

std::string name_of_page(std::string anchor) {
    for (char &c : anchor)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return anchor;
}

/// These lines of book.md at their places, and nothing above them; a heading is a level higher.
std::string lifted(const std::vector<Line> &lines, const std::vector<BookHeading> &headings, std::size_t from,
                   std::size_t end) {
    std::string text(from - 1, '\n');
    for (std::size_t line = from; line < end; ++line) {
        const bool heading = std::ranges::find(headings, line, &BookHeading::line) != headings.end();
        text += lines[line - 1].text.substr(heading ? 1 : 0);
        text += '\n';
    }
    return text;
}

} // namespace

std::vector<BookPart> book_parts(std::string_view book) {
    book.remove_prefix(byte_order_mark(book).size());
    const std::vector<Line> lines = split_lines(book);
    const std::vector<BookHeading> headings = book_headings(book);
    const std::vector<Entry> rows = contents(book);
    const std::size_t table = rows.empty() ? 0 : static_cast<std::size_t>(rows.front().line);
    std::vector<BookPart> parts;
    for (auto heading = headings.begin(); heading != headings.end();) {
        const auto next = std::find_if(heading + 1, headings.end(), [](const auto &h) { return h.level <= 2; });
        const std::size_t end = next == headings.end() ? lines.size() + 1 : next->line;
        const bool has_contents = heading->line <= table && table < end;
        if (heading->level == 2 && !has_contents) {
            parts.push_back({name_of_page(heading->anchor),
                             heading->words,
                             lifted(lines, headings, heading->line, end),
                             {},
                             heading->line < table});
            for (auto within = heading; within != next; ++within) parts.back().anchors.push_back(within->anchor);
        }
        heading = next;
    }
    return parts;
}

std::string book_address(const std::vector<BookPart> &parts, const std::string &anchor) {
    for (const BookPart &part : parts) {
        if (part.anchors.front() == anchor) return part.name + ".html";
        if (std::ranges::find(part.anchors, anchor) != part.anchors.end()) return part.name + ".html#" + anchor;
    }
    return "index.html" + (anchor.empty() ? "" : '#' + anchor);
}

} // namespace course
