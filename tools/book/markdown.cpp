#include "book/markdown.hpp"

#include "ground/lines.hpp"

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

/// Appends the paragraph without its formulas.
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

/// Writes a document's text into `out`; formulas come back in the order in which they were taken out.
struct PlainWriter {
    const std::vector<Formula> &formulas;
    std::size_t next_formula = 0;

    std::string text(std::string literal) {
        for (std::size_t at = 0; (at = literal.find(WithoutFormulas::stand_in, at)) != literal.npos;) {
            const std::string formula = plain_formula(formulas.at(next_formula++).tex);
            literal.replace(at, WithoutFormulas::stand_in.size(), formula);
            at += formula.size();
        }
        return literal;
    }

    std::string inlines(cmark_node *parent) {
        std::string out;
        for (cmark_node *node = cmark_node_first_child(parent); node; node = cmark_node_next(node)) {
            switch (cmark_node_get_type(node)) {
            case CMARK_NODE_TEXT: out += text(literal(node)); break;
            case CMARK_NODE_CODE: out += literal(node); break;
            case CMARK_NODE_SOFTBREAK:
            case CMARK_NODE_LINEBREAK: out += '\n'; break;
            case CMARK_NODE_HTML_INLINE: break;
            case CMARK_NODE_LINK: {
                const std::string words = inlines(node), url = cmark_node_get_url(node);
                out += url.starts_with('#') || url == words ? words : words + " (" + url + ")";
                break;
            }
            default: out += inlines(node);
            }
        }
        return out;
    }

    std::string block(cmark_node *node) {
        switch (cmark_node_get_type(node)) {
        case CMARK_NODE_PARAGRAPH:
        case CMARK_NODE_HEADING: return inlines(node) + '\n';
        case CMARK_NODE_CODE_BLOCK: return indented(literal(node), "    ", "    ");
        case CMARK_NODE_BLOCK_QUOTE: return indented(blocks(node, "\n"), "  ", "  ");
        case CMARK_NODE_ITEM: return indented(blocks(node, "\n"), "- ", "  ");
        case CMARK_NODE_LIST: return blocks(node, "");
        case CMARK_NODE_HTML_BLOCK: {
            static const std::regex tag{"<[^>]*>"};
            const std::string words = std::regex_replace(literal(node), tag, "");
            return words.find_first_not_of(" \n") == words.npos ? "" : words;
        }
        default: return is_table(node) ? table(node) : "";
        }
    }

    std::string table(cmark_node *node) {
        std::string out;
        for (cmark_node *row = cmark_node_first_child(node); row; row = cmark_node_next(row)) {
            for (cmark_node *cell = cmark_node_first_child(row); cell; cell = cmark_node_next(cell))
                out += (cmark_node_previous(cell) ? " | " : "") + inlines(cell);
            out += '\n';
        }
        return out;
    }

    std::string blocks(cmark_node *parent, std::string_view between) {
        std::string out;
        for (cmark_node *node = cmark_node_first_child(parent); node; node = cmark_node_next(node)) {
            const std::string written = block(node);
            if (!out.empty() && !written.empty()) out += between;
            out += written;
        }
        return out;
    }

    static std::string indented(const std::string &text, std::string_view first, std::string_view others) {
        std::string out;
        for (const Line &line : lines_of(text)) {
            if (!line.text.empty()) (out += out.empty() ? first : others) += line.text;
            out += '\n';
        }
        return out;
    }
};

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
    std::vector<std::size_t> paragraph_end(lines_of(text).size() + 1); // 0: no paragraph begins on this line
    each_node(document.get(), [&](cmark_node *node) {
        if (cmark_node_get_type(node) != CMARK_NODE_PARAGRAPH && !is_table(node)) return;
        paragraph_end.at(static_cast<std::size_t>(cmark_node_get_start_line(node)) - 1) =
            static_cast<std::size_t>(cmark_node_get_end_line(node));
    });

    WithoutFormulas result;
    const std::vector<Line> lines = lines_of(text);
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
    const WithoutFormulas taken = take_out_formulas(markdown);
    const Document document = parse_markdown(taken.text);
    return PlainWriter{taken.formulas}.blocks(document.get(), "\n");
}

} // namespace course
