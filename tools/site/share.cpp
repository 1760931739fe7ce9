#include "site/share.hpp"

#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"
#include "site/html.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <regex>

namespace course {
namespace {

std::string of_site(const Tree &tree, const char *name) { return read_file(site_folder(tree) / name); }

/// Without the site's own typefaces, which lie in files of their own.
std::string without_typefaces(const std::string &style) {
    static const std::regex face{R"(@font-face \{[^}]*\}\n?)"};
    return std::regex_replace(style, face, "");
}

std::string style(const Tree &tree) {
    return "<style>\n" + without_typefaces(of_site(tree, "site.css")) + of_site(tree, "play.css") + "</style>\n";
}
std::string script(const std::string &text) { return "<script>\n" + text + "</script>\n"; }

std::string title_of(const Tree &tree, const Section &section) {
    const std::vector<Demo> all = demos(tree);
    const auto demo = std::ranges::find_if(all, [&](const Demo &each) { return each.section.name == section.name; });
    return demo == all.end() ? section.slug() : escaped(demo->about);
}

} // namespace

std::string shared_page(const Tree &tree, const Section &section, const DemoMark &mark) {
    const std::string title = title_of(tree, section),
                      start = mark.start.empty() ? "" : " data-start=\"" + escaped(mark.start) + '"';
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
           + title + "</title>\n" + style(tree) + script(of_site(tree, "theme.js"))
           + "<main>\n<figure class=\"play\" data-demo=\"" + section.name + "\" data-mine" + start + "><figcaption>"
           + title
           + "</figcaption><p>This needs a browser with JavaScript.</p></figure>\n<p class=\"above\">I wrote the "
             "physics of "
             "this, function by function, with <em>Frame by Frame</em>, a course in game physics. <em>Yours</em> is my "
             "code, "
             "and <em>Ours</em> is the book's.</p>\n</main>\n"
           + script(of_site(tree, demo_file(section).c_str()))
           + script(read_file(tree.build / "play" / (section.name + "_mine.js"))) + script(of_site(tree, "draw.js"))
           + script(of_site(tree, "hands.js")) + script(of_site(tree, "play.js")) + "</html>\n";
}

} // namespace course
