#include "book/markdown.hpp"

#include "base/lines.hpp"

#include <cmark-gfm-core-extensions.h>

#include <regex>

namespace course {
namespace {

/// Where the formula or the code that begins here ends; npos if it does not end, and the character is an ordinary one.
std::size_t end_of_span(std::string_view text, std::size_t start, std::size_t fence) {
    const std::string_view closing = text.substr(start, fence);
    for (std::size_t at = start + fence; (at = text.find(closing, at)) != text.npos;) {
        const std::size_t run_end = std::min(text.find_first_not_of(closing[0], at), text.size());
        const bool escaped = closing[0] == '$' && text[at - 1] == '\\';
        if (run_end - at == fence && !escaped) return run_end;
        at = run_end;
    }
    return text.npos;
}

/// Appends the paragraph without formulas.
void take_out(std::string_view paragraph, WithoutFormulas &result) {
    for (std::size_t at = 0; at < paragraph.size();) {
        const char c = paragraph[at];
        std::size_t length = 1;
        if (c == '\\' && at + 1 < paragraph.size()) length = 2;
        if (c == '`' || c == '$') {
            const std::size_t fence = std::min(paragraph.find_first_not_of(c, at), paragraph.size()) - at;
            const std::size_t end = end_of_span(paragraph, at, fence);
            length = end == paragraph.npos ? fence : end - at;
            if (c == '$' && end != paragraph.npos && fence <= 2) {
                const std::string_view formula = paragraph.substr(at + fence, length - 2 * fence);
                result.formulas.push_back({std::string{formula}, fence == 2});
                result.text += WithoutFormulas::stand_in;
                result.text.append(static_cast<std::size_t>(std::ranges::count(formula, '\n')), '\n');
                at += length;
                continue;
            }
        }
        result.text += paragraph.substr(at, length);
        at += length;
    }
}

Cell read_cell(cmark_node *cell) {
    std::string link;
    each_node(cell, [&](cmark_node *node) {
        if (link.empty() && cmark_node_get_type(node) == CMARK_NODE_LINK) link = cmark_node_get_url(node);
    });
    return {words_of(cell), link};
}

Table read_table(cmark_node *table) {
    Table rows;
    for (cmark_node *row = cmark_node_first_child(table); row; row = cmark_node_next(row)) {
        if (cmark_gfm_extensions_get_table_row_is_header(row) != 0) continue;
        rows.push_back({cmark_node_get_start_line(row), {}});
        for (cmark_node *cell = cmark_node_first_child(row); cell; cell = cmark_node_next(cell))
            rows.back().cells.push_back(read_cell(cell));
    }
    return rows;
}

} // namespace

Document parse_markdown(std::string_view text, int options) {
    cmark_gfm_core_extensions_ensure_registered();
    const std::unique_ptr<cmark_parser, decltype(&cmark_parser_free)> parser{cmark_parser_new(options),
                                                                             &cmark_parser_free};
    cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
    cmark_parser_feed(parser.get(), text.data(), text.size());
    return Document{cmark_parser_finish(parser.get())};
}

bool is_table(cmark_node *node) { return std::string_view{cmark_node_get_type_string(node)} == "table"; }

std::vector<Table> tables(std::string_view text) {
    const Document document = parse_markdown(text);
    std::vector<Table> result;
    each_node(document.get(), [&](cmark_node *node) {
        if (is_table(node)) result.push_back(read_table(node));
    });
    return result;
}

WithoutFormulas take_out_formulas(std::string_view text) {
    const Document document = parse_markdown(text);
    std::vector<std::size_t> paragraph_end(split_lines(text).size() + 1); // 0: no paragraph begins on this line
    each_node(document.get(), [&](cmark_node *node) {
        if (cmark_node_get_type(node) != CMARK_NODE_PARAGRAPH && !is_table(node)) return;
        paragraph_end.at(static_cast<std::size_t>(cmark_node_get_start_line(node)) - 1) =
            static_cast<std::size_t>(cmark_node_get_end_line(node));
    });

    WithoutFormulas result;
    const std::vector<Line> lines = split_lines(text);
    for (std::size_t first = 0, next; first < lines.size(); first = next) {
        next = std::max(first + 1, paragraph_end[first]);
        const char *begin = lines[first].text.data();
        const std::string_view whole{begin, static_cast<std::size_t>(lines[next - 1].end.end() - begin)};
        if (paragraph_end[first] > first) take_out(whole, result);
        else result.text += whole;
    }
    return result;
}

std::string words_of(cmark_node *parent) {
    std::string words;
    each_node(parent, [&](cmark_node *node) {
        const cmark_node_type type = cmark_node_get_type(node);
        if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE) words += literal(node);
        if (type == CMARK_NODE_SOFTBREAK) words += ' ';
    });
    return words;
}

std::string plain_text(std::string_view markdown) {
    static const std::regex inner_link{R"(\[([^\]]*)\]\(#[^)]*\))"}, link{R"(\[([^\]]*)\]\(([^)]*)\))"},
        mark{R"(`([^`]*)`|\*+|</?[a-z][^>]*>)"};
    std::string text;
    bool in_listing = false;
    for (const Line &line : split_lines(markdown)) {
        const bool fence = trim(line.text).starts_with("```");
        in_listing = in_listing != fence;
        const bool rule = line.text.starts_with("|:-") || line.text.starts_with("|-"); // below the head of a table
        if (fence || rule) continue;
        std::string words = (in_listing && !line.text.empty() ? "    " : "") + std::string{line.text};
        if (!in_listing) {
            words = std::regex_replace(words, inner_link, "$1");
            words = std::regex_replace(words, link, "$1 ($2)");
            words = std::regex_replace(words, mark, "$1");
        }
        const bool second_empty_line = words.empty() && (text.empty() || text.ends_with("\n\n"));
        if (in_listing || !second_empty_line) text += words + '\n';
    }
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

} // namespace course
