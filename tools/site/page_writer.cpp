#include "site/page_writer.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "book/chunks.hpp"
#include "book/links.hpp"
#include "book/markdown.hpp"
#include "book/weaver.hpp"
#include "check/others.hpp"
#include "site/addresses.hpp"
#include "site/demos.hpp"
#include "site/spot_the_bug.hpp"

#include <cstdlib>
#include <map>
#include <regex>
#include <set>

namespace course {
namespace fs = std::filesystem;
namespace {

/// Code as it is; docs/finish.cjs colours the words of two languages.
std::string block_of(std::string language, const std::string &code, const std::string &how = "") {
    if (language.empty()) language = "plain";
    if (language == "c++") language = "cpp";
    const bool coloured = language == "cpp" || language == "gnuplot";
    return "<pre class=\"" + (coloured ? "code" + how + "\" data-language=\"" : "") + escaped(language) + "\"><code>"
           + escaped(code) + "</code></pre>";
}

/// A path that may break into the next line after a slash.
std::string breakable(std::string path) {
    replace_all(path, "/", "/<wbr>");
    return path;
}

/// The chunks that a page may show, by title.
std::map<std::string, Chunk> chunks_for(const Workspace &workspace, const fs::path &file) {
    std::vector<fs::path> code;
    if (file == workspace.root / "book.md") code = page_of_book(workspace).code;
    for (const Section &section : workspace.sections())
        if (file == workspace.chapter(section)) code = page_of(workspace, section).code;
    std::map<std::string, Chunk> chunks;
    for (const fs::path &each : code)
        for (Chunk &chunk : cut(each)) chunks.try_emplace(chunk.title, chunk);
    return chunks;
}

cmark_node *raw_block(const std::string &enter, const std::string &leave = "") {
    cmark_node *node = cmark_node_new(CMARK_NODE_CUSTOM_BLOCK);
    cmark_node_set_on_enter(node, enter.c_str());
    cmark_node_set_on_exit(node, leave.c_str());
    return node;
}

cmark_node *raw_words(const std::string &html) {
    cmark_node *node = cmark_node_new(CMARK_NODE_HTML_INLINE); // the only raw kind that a cell of a table holds
    cmark_node_set_literal(node, html.c_str());
    return node;
}

void move_children(cmark_node *from, cmark_node *to) {
    while (cmark_node *child = cmark_node_first_child(from)) cmark_node_append_child(to, child);
}

void replace(cmark_node *old, cmark_node *with) {
    cmark_node_replace(old, with);
    cmark_node_free(old);
}

std::string rendered(cmark_node *node) {
    const std::unique_ptr<char, decltype(&std::free)> html{cmark_render_html(node, CMARK_OPT_UNSAFE, nullptr),
                                                           &std::free};
    return html.get();
}

/// Changes a chapter's tree of nodes into one that cmark writes as the site's HTML.
class PageWriter {
  public:
    PageWriter(const Addresses &addresses_, const fs::path &file_, std::string_view text,
               std::map<std::string, Chunk> chunks_)
        : addresses{addresses_}, file{file_}, chunks{std::move(chunks_)}, taken{take_out_formulas(text)} {}

    SitePage write(const std::string &name) {
        const Document document = parse_markdown(taken.text, CMARK_OPT_SMART);
        blocks(document.get());
        return {name, title, "chapter", rendered(document.get()), headings};
    }

  private:
    std::string place(int line) const { return workspace.relative_name(file) + ':' + std::to_string(line); }

    std::string formula(const std::string &tex, bool display, int line) const {
        return "<span class=\"math" + std::string{display ? " display" : ""} + "\" data-from=\"" + place(line) + "\">"
               + escaped(tex) + "</span>";
    }

    void blocks(cmark_node *parent) {
        for (cmark_node *node = cmark_node_first_child(parent), *next; node; node = next) {
            next = cmark_node_next(node);
            block(node);
        }
    }

    void block(cmark_node *node) {
        switch (cmark_node_get_type(node)) {
        case CMARK_NODE_HEADING: heading(node); break;
        case CMARK_NODE_PARAGRAPH: paragraph(node); break;
        case CMARK_NODE_CODE_BLOCK: listing(node); break;
        case CMARK_NODE_HTML_BLOCK: html(node); break;
        case CMARK_NODE_BLOCK_QUOTE: quote(node); break;
        default: is_table(node) ? table(node) : blocks(node);
        }
    }

    void heading(cmark_node *node) {
        const int level = cmark_node_get_heading_level(node);
        const std::string words = words_of(node), anchor = anchors.next(words), tag = 'h' + std::to_string(level);
        lead_may_follow = title.empty();
        std::string begin = "<h1>", end = "</h1>";
        if (title.empty()) {
            title = words;
        } else {
            headings.push_back({level, anchor, words});
            std::erase(headings.back().words, '$');
            begin = "<" + tag + " id=\"" + escaped(anchor) + "\">";
            end = "<a class=\"anchor\" href=\"#" + escaped(anchor) + "\" aria-label=\"Link to "
                  + escaped(headings.back().words) + "\">#</a></" + tag + ">";
        }
        heading_formulas(node);
        cmark_node *block = raw_block(begin, end);
        move_children(node, block);
        replace(node, block);
    }

    /// A quotation, or what a chapter writes as one: the box of an exercise.
    void quote(cmark_node *node) {
        cmark_node *first = cmark_node_first_child(node);
        const bool turn =
            first && cmark_node_get_type(first) == CMARK_NODE_HEADING && words_of(first).starts_with("Your turn");
        const std::string exercise = turn ? exercise_of_box(words_of(first)) : "";
        if (!exercise.empty()) last_box = exercise;
        blocks(node);
        if (!turn) return;
        cmark_node *box = raw_block(box_of(exercise), "</article>");
        move_children(node, box);
        replace(node, box);
    }

    /// The box of an exercise, which may have several: #exercise-7.2, #exercise-7.2-2.
    std::string box_of(const std::string &exercise) {
        if (exercise.empty()) return "<article class=\"turn\">";
        const int before = boxes_so_far[exercise]++;
        return "<article class=\"turn\" id=\"exercise-" + exercise
               + (before > 0 ? '-' + std::to_string(before + 1) : "") + "\" data-exercise=\"" + exercise + "\">";
    }

    /// Of headings no formulas were taken out, since their words are what links name.
    void heading_formulas(cmark_node *heading) {
        static const std::regex dollars{R"(\$([^$]+)\$)"};
        const int line = cmark_node_get_start_line(heading);
        cmark_consolidate_text_nodes(heading);
        std::vector<cmark_node *> texts;
        each_node(heading, [&](cmark_node *node) {
            if (cmark_node_get_type(node) == CMARK_NODE_TEXT) texts.push_back(node);
        });
        for (cmark_node *node : texts) {
            std::string text = literal(node);
            for (std::smatch match; std::regex_search(text, match, dollars); text = match.suffix()) {
                add_text(node, match.prefix());
                cmark_node_insert_before(node, raw_words(formula(match[1], false, line)));
            }
            cmark_node_set_literal(node, text.c_str());
        }
    }

    /// A picture or a command that a forge shows in the place of a demo, which plays here.
    static bool stands_for_a_demo(cmark_node *paragraph) {
        cmark_node *begin = cmark_node_first_child(paragraph);
        if (!begin) return false;
        if (cmark_node_get_type(begin) == CMARK_NODE_EMPH) return words_of(begin) == "Play it:";
        return cmark_node_get_type(begin) == CMARK_NODE_IMAGE
               && std::string_view{cmark_node_get_url(begin)}.starts_with("../../demos/");
    }

    void paragraph(cmark_node *node) {
        const int first = cmark_node_get_start_line(node);
        cmark_node *only = cmark_node_first_child(node);
        if (only && cmark_node_next(only)) only = nullptr;
        if (stands_for_a_demo(node)) {
            inlines(node, first); // the formulas are taken, too
            cmark_node_unlink(node);
            cmark_node_free(node);
        } else if (only && cmark_node_get_type(only) == CMARK_NODE_IMAGE) {
            replace(node, raw_block(figure(only)));
        } else if (only && cmark_node_get_type(only) == CMARK_NODE_EMPH && lead_may_follow) {
            inlines(only, first);
            cmark_node *lead = raw_block("<p class=\"lead\">", "</p>");
            move_children(only, lead);
            replace(node, lead);
        } else {
            inlines(node, first);
        }
        lead_may_follow = false;
    }

    // Words

    void inlines(cmark_node *parent, int line) {
        for (cmark_node *node = cmark_node_first_child(parent), *next; node; node = next) {
            next = cmark_node_next(node);
            switch (cmark_node_get_type(node)) {
            case CMARK_NODE_TEXT: words(node, line); break;
            case CMARK_NODE_SOFTBREAK:
            case CMARK_NODE_LINEBREAK: ++line; break;
            case CMARK_NODE_LINK:
                inlines(node, line);
                link(node);
                break;
            case CMARK_NODE_IMAGE: replace(node, raw_words(image(node, alternative(node)))); break;
            case CMARK_NODE_CODE: code(node); break;
            default: inlines(node, line);
            }
        }
    }

    /// Only long code may break within a line.
    static void code(cmark_node *node) {
        constexpr std::size_t unbroken = 24;
        const std::string text = literal(node);
        if (text.size() > unbroken) replace(node, raw_words("<code class=\"long\">" + escaped(text) + "</code>"));
    }

    /// Puts the formulas back, in the order in which they were taken out.
    void words(cmark_node *node, int line) {
        const std::string text = literal(node);
        std::size_t from = 0;
        for (std::size_t at; (at = text.find(WithoutFormulas::stand_in, from)) != text.npos;) {
            add_text(node, text.substr(from, at - from));
            const auto &[tex, display] = taken.formulas.at(formulas_back++);
            cmark_node_insert_before(node, raw_words(formula(tex, display, line)));
            from = at + WithoutFormulas::stand_in.size();
        }
        cmark_node_set_literal(node, text.c_str() + from);
    }

    static void add_text(cmark_node *before, const std::string &text) {
        cmark_node *node = cmark_node_new(CMARK_NODE_TEXT);
        cmark_node_set_literal(node, text.c_str());
        cmark_node_insert_before(before, node);
    }

    /// A link to what the site does not have becomes plain words.
    void link(cmark_node *node) {
        if (const auto to = addresses.of(file, cmark_node_get_url(node))) {
            cmark_node_set_url(node, to->c_str());
            return;
        }
        cmark_node_insert_before(node, raw_words("<span class=\"path\">"));
        while (cmark_node *child = cmark_node_first_child(node)) cmark_node_insert_before(node, child);
        replace(node, raw_words("</span>"));
    }

    // Pictures

    std::string alternative(cmark_node *image) const {
        const std::string words = words_of(image);
        if (contains(words, WithoutFormulas::stand_in))
            throw UserError{place(cmark_node_get_start_line(cmark_node_parent(image)))
                            + ": write what the picture shows in plain characters, without formulas"};
        return words;
    }

    std::string image(cmark_node *node, const std::string &alt) const {
        const std::string url = cmark_node_get_url(node);
        const auto to = addresses.of(file, url);
        if (!to || is_on_the_web(url))
            throw UserError{place(cmark_node_get_start_line(cmark_node_parent(node)))
                            + ": the site cannot show the picture " + url + "; give it as an SVG or PNG of the course"};
        return "<img src=\"" + escaped(*to) + "\" alt=\"" + escaped(alt) + "\"" + size_of(workspace.root / *to) + ">";
    }

    /// Width and height, so that the page knows them before the picture is there.
    static std::string size_of(const fs::path &svg) {
        static const std::regex size{R"re(<svg[^>]*?\swidth="(\d+)"[^>]*?\sheight="(\d+)")re"};
        const std::string head = svg.extension() == ".svg" ? read_file(svg).substr(0, 1000) : "";
        std::smatch match;
        if (!std::regex_search(head, match, size)) return "";
        return " width=\"" + match[1].str() + "\" height=\"" + match[2].str() + "\"";
    }

    /// A picture with a caption, and the script that draws it. (Whoever cannot see it hears the
    /// words once, from the picture.)
    std::string figure(cmark_node *node) {
        const std::string alt = alternative(node), url = cmark_node_get_url(node);
        const auto script = addresses.of(file, fs::path{url}.replace_extension(".gp").generic_string());
        std::string caption = "<span aria-hidden=\"true\">" + escaped(alt) + "</span>";
        if (script && script->starts_with("source_"))
            caption += " <a class=\"from\" href=\"" + *script + "\">How it is drawn</a>";
        return "<figure class=\"picture\">" + image(node, alt) + "<figcaption>" + caption + "</figcaption></figure>";
    }

    // Listings

    void listing(cmark_node *node) {
        std::string code = literal(node), caption;
        const auto marked = mark_title(code.substr(0, code.find('\n')));
        if (const auto chunk = marked ? chunks.find(*marked) : chunks.end(); chunk != chunks.end()) {
            caption = caption_of(chunk->second);
            code.erase(0, code.find('\n') + 1);
        }
        const std::string language = cmark_node_get_fence_info(node);
        replace(node, raw_block("<figure class=\"listing\">" + caption + block_of(language, code) + "</figure>"));
    }

    /// Title, file and line: that of the first line below the mark.
    std::string caption_of(const Chunk &chunk) const {
        const std::string line = std::to_string(chunk.line + 1);
        return "<figcaption><span><span class=\"title\">" + escaped(chunk.title) + "</span> <a class=\"from\" href=\""
               + page_name(workspace, chunk.file) + ".html#L" + line + "\">"
               + breakable(workspace.relative_name(chunk.file)) + ":" + line + "</a></span></figcaption>";
    }

    // Folds

    void html(cmark_node *node) {
        static const std::regex summary{R"(<summary>([\s\S]*?)</summary>)"};
        const std::string text = literal(node);
        std::string out;
        auto from = text.begin();
        for (std::sregex_iterator match{text.begin(), text.end(), summary}; match != std::sregex_iterator{}; ++match) {
            out.append(from, text.begin() + match->position(1));
            out += markdown((*match)[1], cmark_node_get_start_line(node));
            from = text.begin() + match->position(1) + match->length(1);
        }
        out.append(from, text.end());
        static const std::regex solution{R"(<details>(\s*<summary>Our solution of (\d+\.\d+)))"},
            hint{R"(<details>(\s*<summary>)(\d+\.\d+), a hint: )"};
        if (std::smatch match; std::regex_search(text, match, solution)) out = others(match[2]) + out;
        out = std::regex_replace(out, solution, "<details class=\"solution\">$1");
        for (std::smatch match; std::regex_search(out, match, hint);)
            out = match.prefix().str() + "<details class=\"hint\">" + match[1].str() + "Hint "
                  + std::to_string(++hints_so_far[match[2]]) + ": " + match.suffix().str();
        if (auto mark = demo_mark(text)) {
            mark->exercise = last_box;
            out = demo(*mark, cmark_node_get_start_line(node));
        }
        if (std::string_view{text}.starts_with(suspects_mark)) out = two_suspects();
        static const std::regex words{R"(<!-- words: ([^<>]*) -->)"};
        out = std::regex_replace(out, words, "<p class=\"words\" hidden>$1</p>");
        cmark_node_set_literal(node, out.c_str());
    }

    /// Before our solution, what docs/done.js shows once the reader's own is right.
    std::string others(const std::string &number) {
        const std::optional<Section> section = section_of(number);
        if (!section || !shown_others.insert(number).second) return "";
        const std::vector<OtherAnswer> all = other_answers(workspace, *section, number);
        if (all.empty()) return "";
        std::string fold = "<details class=\"others\" data-exercise=\"" + number + "\" hidden><summary>"
                           + words_for_others(all.size()) + "</summary>";
        for (const auto &[claim, code] : all)
            fold += "<p>" + markdown(with_capital(claim), 0) + ":</p>" + block_of("cpp", code);
        return fold + "</details>";
    }
    std::optional<Section> section_of(const std::string &number) const {
        for (const Section &section : workspace.sections())
            if (workspace.chapter(section) == file && number.starts_with(section.short_number() + '.')) return section;
        return {};
    }

    /// A demo's place; nothing if demos/ has none.
    std::string demo(const DemoMark &mark, int line) {
        for (const Demo &one : known_demos())
            if (one.mark.name == mark.name)
                return demo_figure(one, demo_id(mark, demos_so_far++), mark, markdown(mark.task, line));
        return "";
    }

    /// The demo of this chapter twice, once with a bug; nothing if there is none.
    std::string two_suspects() {
        for (const Demo &one : known_demos())
            if (workspace.chapter(one.section) == file) return spot_the_bug(workspace, one);
        return "";
    }

    const std::vector<Demo> &known_demos() {
        if (!all_demos) all_demos = demos(workspace);
        return *all_demos;
    }

    /// A few words of Markdown with formulas, within HTML.
    std::string markdown(const std::string &text, int line) const {
        PageWriter words{addresses, file, text, {}};
        const Document document = parse_markdown(words.taken.text, CMARK_OPT_SMART);
        for (cmark_node *node = cmark_node_first_child(document.get()); node; node = cmark_node_next(node))
            words.inlines(node, line);
        static const std::regex paragraph{R"(^<p>([\s\S]*)</p>\s*$)"};
        return std::regex_replace(rendered(document.get()), paragraph, "$1");
    }

    void table(cmark_node *node) {
        for (cmark_node *row = cmark_node_first_child(node); row; row = cmark_node_next(row))
            for (cmark_node *cell = cmark_node_first_child(row); cell; cell = cmark_node_next(cell))
                inlines(cell, cmark_node_get_start_line(cell));
        cmark_node *box = raw_block("<div class=\"table\">", "</div>");
        cmark_node_insert_before(node, box);
        cmark_node_append_child(box, node);
    }

    const Addresses &addresses;
    const Workspace &workspace = addresses.workspace;
    const fs::path &file;
    const std::map<std::string, Chunk> chunks;
    const WithoutFormulas taken;
    Anchors anchors;
    std::string title;
    std::vector<Heading> headings;
    bool lead_may_follow = false;
    std::size_t formulas_back = 0;
    std::optional<std::vector<Demo>> all_demos; ///< read at the first mark
    std::size_t demos_so_far = 0;
    std::map<std::string, int> boxes_so_far, hints_so_far; ///< by exercise
    std::set<std::string> shown_others;                    ///< of these exercises
    std::string last_box;                                  // the exercise of the last one
};

} // namespace

SitePage written_page(const Addresses &addresses, const fs::path &file, std::string_view text,
                      const std::string &name) {
    text.remove_prefix(byte_order_mark(text).size());
    return PageWriter{addresses, file, text, chunks_for(addresses.workspace, file)}.write(name);
}

SitePage source_page(const Workspace &workspace, const fs::path &file) {
    const std::string path = workspace.relative_name(file), code = read_file(file);
    return {page_name(workspace, file),
            path,
            "source",
            "<h1><code>" + breakable(path) + "</code></h1>"
                + block_of(file.extension() == ".gp" ? "gnuplot" : "cpp", code.substr(byte_order_mark(code).size()),
                           " numbered"),
            {}};
}

} // namespace course
