#include "book/links.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "book/html.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace course {
namespace fs = std::filesystem;
namespace {

struct Link {
    std::string url;
    int line;
};

/// What a file links to, and what in it can be linked to.
struct Endpoints {
    std::vector<Link> links;
    std::set<std::string> anchors;
};

/// Reads a piece of HTML, which begins in this line.
void read_html(const std::string &html, int line, Endpoints &page) {
    each_tag(html, [&](const Tag &tag) {
        const auto above = std::count(html.data(), tag.whole.data(), '\n');
        for (const char *name : {"id", "name"})
            if (const std::string id = tag.attribute(name); !id.empty()) page.anchors.insert(id);
        for (const char *name : {"href", "src"})
            if (const std::string url = tag.attribute(name); !url.empty())
                page.links.push_back({url, line + static_cast<int>(above)});
    });
}

Endpoints read_page(std::string_view text) {
    const WithoutFormulas taken = take_out_formulas(text.substr(byte_order_mark(text).size()));
    const Document document = parse_markdown(taken.text);
    Endpoints page;
    Anchors anchors;
    each_node(document.get(), [&](cmark_node *node) {
        const int line = cmark_node_get_start_line(node);
        switch (cmark_node_get_type(node)) {
        case CMARK_NODE_LINK:
        case CMARK_NODE_IMAGE: page.links.push_back({cmark_node_get_url(node), line}); break;
        case CMARK_NODE_HTML_BLOCK:
        case CMARK_NODE_HTML_INLINE: read_html(literal(node), line, page); break;
        case CMARK_NODE_HEADING: page.anchors.insert(anchors.next(words_of(node))); break;
        default: break;
        }
    });
    return page;
}

/// Why a link leads nowhere; empty if it doesn't.
std::string trouble_with(const std::string &url, const fs::path &file, const fs::path &root, const Endpoints &here) {
    if (is_on_the_web(url)) return "";
    const auto hash = url.find('#');
    const std::string path = unescaped(url.substr(0, hash));
    const std::string anchor = hash == url.npos ? "" : unescaped(url.substr(hash + 1));
    const std::string named = "`" + url + "`";

    if (path.starts_with('/'))
        return "the link " + named + " begins with a slash; write it as seen from this file's folder.";
    fs::path target = path.empty() ? file : (file.parent_path() / path).lexically_normal();
    if (target.lexically_relative(root).string().starts_with(".."))
        return "the link " + named + " leads out of the course; name a file in it.";
    if (!fs::exists(target)) return "the link " + named + " leads to no file; correct it, or add the file.";
    if (anchor.empty()) return "";
    if (fs::is_directory(target)) target /= "README.md"; // which a forge shows there
    if (target.extension() != ".md" || !fs::exists(target)) return "";
    const Endpoints there = path.empty() ? Endpoints{} : read_page(read_file(target));
    return (path.empty() ? here : there).anchors.contains(anchor)
               ? ""
               : "the link " + named + " leads to no heading of " + target.lexically_relative(root).generic_string()
                     + "; correct what comes after the #.";
}

} // namespace

bool is_on_the_web(std::string_view url) {
    static const std::regex scheme{R"(([A-Za-z][A-Za-z0-9+.-]*:|//)[\s\S]*)"};
    return std::regex_match(url.begin(), url.end(), scheme);
}

std::string unescaped(std::string_view url) {
    std::string text;
    for (std::size_t i = 0; i < url.size(); ++i) {
        const std::string hex{url.substr(i + 1, 2)};
        const bool escaped =
            url[i] == '%' && hex.size() == 2 && hex.find_first_not_of("0123456789abcdefABCDEF") == hex.npos;
        text += escaped ? static_cast<char>(std::stoi(hex, nullptr, 16)) : url[i];
        if (escaped) i += 2;
    }
    return text;
}

std::string anchor_of(std::string_view heading) {
    // As forges do it: small letters, digits, `-` and `_` stay, a blank becomes `-`, other signs go. Letters beyond
    // ASCII stay as well; of the signs there, these are the ones that books use.
    static const std::regex signs{
        "\xE2[\x80-\x8F].|\xC2[\x80-\xBF]|\xC3[\x97\xB7]"}; // dashes, quotes, arrows, maths; ·°²; ×÷
    std::string anchor;
    for (const char c : std::regex_replace(std::string{heading}, signs, "")) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == ' ') anchor += '-';
        else if (byte >= 0x80 || c == '-' || c == '_' || std::isalnum(byte))
            anchor += static_cast<char>(std::tolower(byte));
    }
    return anchor;
}

std::vector<Finding> dead_links(const fs::path &file, std::string_view text, const fs::path &root) {
    const Endpoints page = read_page(text);
    std::vector<Finding> dead;
    for (const Link &link : page.links)
        if (const std::string trouble = trouble_with(link.url, file, root, page); !trouble.empty())
            dead.push_back({file, link.line, trouble});
    return dead;
}

} // namespace course
