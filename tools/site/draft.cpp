#include "site/draft.hpp"

#include "ground/complaint.hpp"
#include "ground/text.hpp"

#include <regex>

namespace course {
namespace {

bool is_a(const Element &element, std::string_view name, std::string_view its_class) {
    return element.name() == name && element.has_class(its_class);
}

std::string trimmed(const std::string &text) {
    static const std::regex ends{R"(^\s+|\s+$)"}, within{R"(\s+)"};
    return std::regex_replace(std::regex_replace(text, ends, ""), within, " ");
}

/// The piece of a page that is the page's own: of a chapter what we gave Doxygen, without its box and its anchor.
std::string contents_of(const Html &page, const std::string &name, const char *box) {
    static const std::regex anchor{R"re(^\s*<p\s*>\s*<a class="anchor" id="[^"]*"></a>\s*</p>)re"};
    const Element contents = page.first([&](const Element &e) { return is_a(e, "div", box); });
    if (!contents.node)
        throw Complaint{"Doxygen wrote " + name + ".html without contents; is another version at work?"};
    return std::regex_replace(std::string{contents.inner()}, anchor, "");
}

/// "wall::Touch Struct Reference" is a title of Doxygen's.
std::string interface_title(const Html &page) {
    static const std::regex reference{R"((.*) (Namespace|Struct|Class|Union|Concept)( Template)? Reference.*)"};
    const Element title = page.first([](const Element &e) { return is_a(e, "div", "title"); });
    const std::string words = title.node ? trimmed(title.text()) : "";
    std::smatch found;
    return std::regex_match(words, found, reference) ? found[1].str() : "";
}

/// Without "More...", since the name before it leads there as well, and without a heading that says "Description".
std::string without_repetitions(const std::string &contents) {
    static const std::regex said{
        R"re(\s*<a href="[^"]*">More\.\.\.</a>|<h2 class="groupheader">Detailed Description</h2>)re"};
    return std::regex_replace(contents, said, "");
}

/// The spaces in "7.2 N s" and "(3, 4) m": numbers and their unit stay on one line.
std::vector<std::string_view> spaces_before_units(std::string_view text) {
    static const std::regex quantity{"\\d\\)?(\\s)(?:N(\\s)s|px|[mk]?m|k?g|m?s|N|J|Hz|rad|%|kB|MB|GB)(?![A-Za-z0-9])"};
    std::vector<std::string_view> result;
    using Found = std::regex_iterator<std::string_view::iterator>;
    for (Found found{text.begin(), text.end(), quantity}, end; found != end; ++found)
        for (const auto &space : {(*found)[1], (*found)[2]})
            if (space.matched) result.push_back(text.substr(static_cast<std::size_t>(space.first - text.begin()), 1));
    return result;
}

/// A formula with the comma behind it in its last unbreakable piece: a browser would begin a line with it otherwise.
/// A screen reader passes over the pieces, and reads the comma behind the formula's MathML.
std::string with_mark(std::string formula, const std::string &mark) {
    const auto end = formula.rfind("</span></span></span>"); // of the piece, of all pieces, of the formula
    if (end == formula.npos) return formula + mark;
    formula.insert(end, "<span class=\"mark\">" + mark + "</span>");
    const auto math = formula.find("</math>");
    return math == formula.npos ? formula : formula.insert(math + 7, mark);
}

/// A listing of Doxygen's, one `div` a line, as the `pre` that it is; with numbered lines if it is a whole file.
std::string listing(const Element &fragment, const Interface *known, bool numbered) {
    // Doxygen takes a variable `motion` for the namespace of that name.
    static const std::regex nothing{R"(<span class="comment"></span>)"},
        space{R"re(<a class="code hl_namespace" href="[^"]*">([^<]*)</a>)re"};
    std::map<std::string, int> seen;
    std::string out = "<pre class=\"code" + std::string{numbered ? " numbered" : ""} + "\"><code>";
    int number = 0;
    for (const Element &line : fragment.children()) {
        if (!is_a(line, "div", "line")) continue; // what Doxygen would show when the mouse rests
        std::string words = std::regex_replace(std::regex_replace(std::string{line.inner()}, nothing, ""), space, "$1");
        if (words == " ") words.clear();
        if (known) words = linked(words, *known, seen);
        if (numbered) out += "<span class=\"line\" id=\"L" + std::to_string(++number) + "\">" + words + "</span>\n";
        else (out += words) += '\n';
    }
    return out + "</code></pre>";
}

} // namespace

Draft::Draft(std::string name, const std::string &doxygens_html) : own_name{std::move(name)}, body{""} {
    const Html page{doxygens_html};
    own_title = interface_title(page);
    interface = !own_title.empty();
    std::string contents = contents_of(page, own_name, interface ? "contents" : "textblock");
    if (interface) contents = "<h1><code>" + escaped(own_title) + "</code></h1>\n" + without_repetitions(contents);
    body = Html{contents};
    if (const Element h1 = body.first([](const Element &e) { return e.name() == "h1"; }); h1.node)
        own_title = trimmed(h1.text());
}

std::vector<Heading> Draft::headings() const {
    std::vector<Heading> result;
    body.each([&](const Element &e) {
        const bool is_heading = e.name().size() == 2 && e.name()[0] == 'h' && e.name()[1] >= '2' && e.name()[1] <= '6';
        if (!is_heading || !e.has("id")) return true;
        std::string words = e.text();
        if (const auto children = e.children(); !children.empty() && children.back().has_class("anchor"))
            words.erase(words.rfind(children.back().text()));
        result.push_back({e.name()[1] - '0', std::string{e.attribute("id")}, trimmed(words)});
        return false;
    });
    return result;
}

std::vector<FormulaAt> Draft::formulas() const {
    std::vector<FormulaAt> result;
    body.each([&](const Element &e) {
        if (e.name() == "span" && e.has_class("math"))
            result.push_back({e.text(), std::string{e.attribute("data-from")}, e.has_class("display")});
        return true;
    });
    return result;
}

std::string Draft::finished(const std::vector<std::string> &typeset, const Interface *known) {
    const bool is_source = own_name.starts_with("source_");
    std::size_t formula = 0;
    std::map<std::string, int> seen;
    body.each([&](const Element &e) {
        if (is_a(e, "span", "kept")) {
            const std::string tex = e.children().front().text();
            body.replace(e.outer(), with_mark(typeset.at(formula++), e.text().substr(tex.size())));
            return false;
        }
        if (e.name() == "span" && e.has_class("math")) {
            body.replace(e.outer(), typeset.at(formula++));
            return false;
        }
        if (is_a(e, "div", "fragment")) {
            body.replace(e.outer(), listing(e, known, is_source));
            return false;
        }
        if (!is_source && e.name() != "code" && e.name() != "pre")
            for (const std::string_view text : e.own_texts())
                for (const std::string_view space : spaces_before_units(text)) body.replace(space, "&#160;");
        if (e.name() == "h2") seen.clear(); // so that each part of a chapter has its links
        if (e.name() == "code" && known) {
            const auto found = known->names.find(e.text());
            if (found != known->names.end() && seen[e.text()]++ == 0)
                body.replace(e.outer(), "<a class=\"code\" href=\"" + found->second.address + "\">"
                                            + std::string{e.outer()} + "</a>");
        }
        return e.name() != "a" && e.name() != "h1" && e.name() != "h2" && e.name() != "h3" && e.name() != "summary"
               && e.name() != "pre";
    });
    return body.changed();
}

} // namespace course
