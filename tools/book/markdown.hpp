#pragma once
// cmark-gfm, the reader of Markdown that forges use, tables included, with C++ types.

#include <cmark-gfm.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct FreeNode {
    void operator()(cmark_node *node) const { cmark_node_free(node); }
};
using Document = std::unique_ptr<cmark_node, FreeNode>;

/// Lines are counted from 1. A byte-order mark is not expected.
Document parse_markdown(std::string_view text, int options = CMARK_OPT_DEFAULT);

/// Visits every node, in the order of the text.
template <class Visit> void each_node(cmark_node *root, Visit visit) {
    const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> iterator{cmark_iter_new(root), &cmark_iter_free};
    for (cmark_event_type event; (event = cmark_iter_next(iterator.get())) != CMARK_EVENT_DONE;)
        if (event == CMARK_EVENT_ENTER) visit(cmark_iter_get_node(iterator.get()));
}

inline std::string literal(cmark_node *node) {
    const char *text = cmark_node_get_literal(node);
    return text ? text : "";
}

/// What a heading, a link or a cell of a table says: words and code, without stars or backticks.
std::string words_of(cmark_node *parent);

bool is_table(cmark_node *node);

/// A cell of a table.
struct Cell {
    std::string words;
    std::string link; ///< where the first link leads to; "" without one
};

struct Row {
    int line = 0; ///< from 1
    std::vector<Cell> cells;
};
using Table = std::vector<Row>; ///< without the head

/// All tables of a text, in order.
std::vector<Table> tables(std::string_view text);

/// What stood between `$` and `$`, or `$$` and `$$`.
struct Formula {
    std::string tex;
    bool display = false; ///< set apart from the text
};

/// A text without formulas, which Markdown does not know: it would read their backslashes as escapes.
struct WithoutFormulas {
    static constexpr std::string_view stand_in = "\xEE\x80\x80"; ///< a private character, U+E000, for each formula
    std::string text;                                            ///< with as many lines as before
    std::vector<Formula> formulas;                               ///< in order
};
WithoutFormulas take_out_formulas(std::string_view text);

/// A piece of Markdown without formulas, as a terminal shows it: no backticks, stars, tags or fences, and code indented.
std::string plain_text(std::string_view markdown);

} // namespace course
