#include "book/chapter.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace course {
namespace {

class FenceReader {
  public:
    FenceReader(std::string_view text, const std::filesystem::path &path, Chapter &result)
        : file{path}, lines{split_lines(text)}, chapter{result} {}

    void read(cmark_node *root) {
        each_node(root, [&](cmark_node *node) {
            if (cmark_node_get_type(node) == CMARK_NODE_CODE_BLOCK || cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK
                || cmark_node_get_type(node) == CMARK_NODE_PARAGRAPH || cmark_node_get_type(node) == CMARK_NODE_HEADING
                || is_table(node))
                begins.insert(cmark_node_get_start_line(node));
        });
        each_node(root, [&](cmark_node *node) {
            if (cmark_node_get_type(node) == CMARK_NODE_CODE_BLOCK) code(node);
            if (cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK) lost_in(node);
        });
    }

  private:
    const Line &at(int line) const { return lines.at(static_cast<std::size_t>(line) - 1); }

    /// Code is in a fence, or indented by four blanks.
    void code(cmark_node *node) {
        Fence fence;
        int length = 0, indent = 0;
        if (cmark_node_get_fenced(node, &length, &indent, &fence.sign) == 0) return lost_in(node);
        fence.length = static_cast<std::size_t>(length);
        fence.line = cmark_node_get_start_line(node);
        fence.column = static_cast<std::size_t>(cmark_node_get_start_column(node) - 1);
        fence.language = cmark_node_get_fence_info(node);
        const std::string code = literal(node);
        for (const Line &line : split_lines(code)) fence.content.emplace_back(line.text);

        // A fence without an end reaches to that of the text or of its quote; or it swallows the next one.
        const int last = cmark_node_get_end_line(node);
        if (last == fence.line + static_cast<int>(fence.content.size()) + 1 && closes(last, fence)) fence.end = last;
        const int swallowed = opening_inside(fence);
        if (swallowed != 0) fence.end = 0;
        if (fence.end == 0)
            broken(fence.line,
                   "this fence has no end"
                       + (swallowed != 0 ? " before the next one, in line " + std::to_string(swallowed) : "") + "; put "
                       + std::string(fence.length, fence.sign) + " on a line of its own where its code ends.");
        chapter.fences.push_back(std::move(fence));
    }

    bool closes(int last, const Fence &fence) const {
        if (last > static_cast<int>(lines.size()) || begins.contains(last)) return false;
        const std::string_view line = without_blanks_behind(at(last).text);
        const std::size_t before = line.find_last_not_of(fence.sign) + 1;
        return line.size() - before >= fence.length;
    }

    /// The line in which the fence holds what can only be another fence; 0 if it holds none.
    static int opening_inside(const Fence &fence) {
        for (std::size_t i = 0; i < fence.content.size(); ++i)
            if (run_of(fence.sign, fence.content[i]) >= fence.length) return fence.line + 1 + static_cast<int>(i);
        return 0;
    }

    /// A listing that Markdown takes for something else.
    void lost_in(cmark_node *node) {
        int line = cmark_node_get_start_line(node);
        const std::string text = literal(node);
        for (const Line &content : split_lines(text)) {
            if (run_of('`', content.text) >= 3 || run_of('~', content.text) >= 3) {
                broken(line, cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK
                                 ? "Markdown sees no fence here, but HTML; put an empty line above it."
                                 : "Markdown sees no fence here, since it is indented by four blanks; take them out.");
                return;
            }
            ++line;
        }
    }

    void broken(int line, std::string message) { chapter.broken.push_back({file, line, std::move(message)}); }

    const std::filesystem::path &file;
    std::vector<Line> lines;
    std::set<int> begins; ///< lines on which a block begins
    Chapter &chapter;
};

bool is_html(cmark_node *node) { return cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK; }

int count(const std::string &text, std::string_view word) {
    int n = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += word.size()) ++n;
    return n;
}

int folds_opened(const std::string &html) { return count(html, "<details") - count(html, "</details>"); }

/// The piece of HTML that ends the fold which `start` opens; null if there is none.
cmark_node *end_of_fold(cmark_node *start) {
    int depth = folds_opened(literal(start));
    cmark_node *node = start;
    while (depth > 0 && (node = cmark_node_next(node)))
        if (is_html(node)) depth += folds_opened(literal(node));
    return node;
}

void find_open_folds(cmark_node *root, const std::filesystem::path &file, Chapter &chapter) {
    each_node(root, [&](cmark_node *node) {
        if (is_html(node) && folds_opened(literal(node)) > 0 && !end_of_fold(node))
            chapter.broken.push_back({file, cmark_node_get_start_line(node),
                                      "this fold has no end; put a line `</details>` below what it hides."});
    });
}

std::string_view without_byte_order_mark(std::string_view text) { return text.substr(byte_order_mark(text).size()); }

/// The functions, types and constants that a chunk defines: what a line which is not indented names first before a
/// bracket, after `struct`, or before a value.
std::vector<std::string> defined_in(const Chunk &chunk) {
    static const std::regex definition{R"(^[A-Za-z](?:[^(={]*[ &*])?(\w+)(?:\(| = |\{| \{).*)"};
    std::vector<std::string> names;
    for (const std::string &line : chunk.lines)
        if (std::smatch match; std::regex_match(line, match, definition)) names.push_back(match[1]);
    return names;
}

bool mentions(const std::vector<Chunk> &chunks, const std::string &name) {
    const std::regex word{"\\b" + name + "\\b"};
    for (const Chunk &chunk : chunks)
        for (const std::string &line : chunk.lines)
            if (std::regex_search(line, word)) return true;
    return false;
}

} // namespace

std::size_t run_of(char sign, std::string_view line) {
    const std::string_view text = trim(line);
    return std::min(text.find_first_not_of(sign), text.size());
}

Chapter read_chapter(std::string_view text, const std::filesystem::path &file) {
    text = without_byte_order_mark(text);
    const Document document = parse_markdown(text);
    Chapter chapter;
    FenceReader{text, file, chapter}.read(document.get());
    if (chapter.broken.empty()) find_open_folds(document.get(), file, chapter);
    return chapter;
}

std::vector<Hint> hints(std::string_view whole) {
    static const std::regex summary{R"(<summary>\s*(\d+\.\d+), a hint: ([\s\S]*?)\s*</summary>([\s\S]*))"};
    const std::string_view text = without_byte_order_mark(whole);
    const std::vector<Line> lines = split_lines(text);
    const Document document = parse_markdown(text);

    std::vector<Hint> result;
    each_node(document.get(), [&](cmark_node *node) {
        const std::string html = is_html(node) ? literal(node) : "";
        std::smatch match;
        if (!std::regex_search(html, match, summary)) return;
        std::string body = match[3]; // text directly below the summary, without an empty line between
        cmark_node *const end = end_of_fold(node);
        const int last = end ? cmark_node_get_start_line(end) - 1 : static_cast<int>(lines.size());
        for (int line = cmark_node_get_end_line(node); line < last; ++line)
            (body += lines[static_cast<std::size_t>(line)].text) += '\n';
        std::string title = plain_text(match[2].str());
        if (title.ends_with('\n')) title.pop_back();
        result.push_back({match[1], title, plain_text(body), cmark_node_get_start_line(node)});
    });
    return result;
}

std::string exercise_of_box(const std::string &heading) {
    static const std::regex number{R"(^Your turn: (\d+\.\d+))"};
    std::smatch match;
    return std::regex_search(heading, match, number) ? match[1].str() : "";
}

std::optional<DemoMark> demo_mark(const std::string &html) {
    static const std::regex mark{R"(<!-- demo: ([a-z]\w*)( mine)?(?:, ([^|\n]*\S))? \| (\S.*) -->\s*)"};
    std::smatch match;
    if (!std::regex_match(html, match, mark)) return {};
    return DemoMark{.name = match[1], .start = match[3], .task = match[4], .mine = match[2].matched, .exercise = {}};
}

std::vector<DemoMark> demo_marks(std::string_view chapter) {
    const Document document = parse_markdown(without_byte_order_mark(chapter));
    std::vector<DemoMark> marks;
    std::string exercise;
    each_node(document.get(), [&](cmark_node *node) {
        if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
            if (const std::string number = exercise_of_box(words_of(node)); !number.empty()) exercise = number;
        }
        auto mark = is_html(node) ? demo_mark(literal(node)) : std::nullopt;
        if (!mark) return;
        mark->exercise = exercise;
        mark->line = cmark_node_get_start_line(node);
        marks.push_back(std::move(*mark));
    });
    return marks;
}

std::vector<Finding> misshapen_demos(std::string_view text, const std::filesystem::path &file) {
    const Document document = parse_markdown(without_byte_order_mark(text));
    std::vector<Finding> findings;
    each_node(document.get(), [&](cmark_node *node) {
        if (!is_html(node) && cmark_node_get_type(node) != CMARK_NODE_HTML_INLINE) return;
        const std::string html = literal(node);
        if (html.find("<!-- demo") == html.npos || (is_html(node) && demo_mark(html))) return;
        findings.push_back({file, cmark_node_get_start_line(node),
                            "write a demo's place as `<!-- demo: name | what to try, and what to watch -->`, on a line "
                            "of its own."});
    });
    return findings;
}

std::vector<Chunk> solution(const Workspace &workspace, const Section &section, std::string_view number) {
    const std::string own = "Solution " + std::string{number};
    const auto is_own = [&](const Chunk &chunk) { return chunk.title == own || chunk.title.starts_with(own + ":"); };
    std::vector<Chunk> chunks = cut(workspace.solution(section));
    if (std::ranges::none_of(chunks, is_own))
        throw UserError{"solutions/" + section.name + ".cpp has no solution of " + std::string{number}
                        + "; a line `//> " + own + ": ...` would begin it"};
    // And the helpers above it that it uses, or that they use: what is for others would give away their solution.
    std::vector<Chunk> result;
    for (auto chunk = chunks.rbegin(); chunk != chunks.rend(); ++chunk) {
        const auto names = chunk->title.starts_with("Solution:") ? defined_in(*chunk) : std::vector<std::string>{};
        const auto used = [&](const std::string &name) { return mentions(result, name); };
        if (is_own(*chunk) || std::ranges::any_of(names, used)) result.insert(result.begin(), *chunk);
    }
    return result;
}

std::vector<ListedExercise> exercise_table(std::string_view chapter) {
    static const std::regex number{R"(\d+\.\d+)"};
    std::vector<ListedExercise> exercises;
    for (const Table &table : tables(chapter))
        for (const auto &[line, cells] : table)
            if (cells.size() > 2 && std::regex_match(cells[0].words, number))
                exercises.push_back(
                    {cells[0].words, cells[1].words.substr(0, cells[1].words.find(':')), cells[2].words, line});
    return exercises;
}

std::vector<ListedExercise> declared_exercises(std::string_view header) {
    static const std::regex declaration{R"re(COURSE_EXERCISE\(\s*"([^"]*)",\s*(\w+),\s*\w+,\s*(\w+))re"};
    std::vector<ListedExercise> exercises;
    const char *const begin = header.data();
    for (std::cregex_iterator match{begin, begin + header.size(), declaration}, end; match != end; ++match) {
        const auto above = std::count(begin, begin + match->position(), '\n');
        exercises.push_back({(*match)[1], (*match)[3], (*match)[2], 1 + static_cast<int>(above)});
    }
    return exercises;
}

} // namespace course
