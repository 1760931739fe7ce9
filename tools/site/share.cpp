#include "site/share.hpp"

#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/build.hpp"
#include "site/progress_script.hpp"

#include <regex>

namespace course {
namespace {

std::string of_site(const Tree &tree, const std::string &name) { return read_file(site_folder(tree) / name); }

/// Without the site's own typefaces, which lie in files of their own.
std::string without_typefaces(const std::string &style) {
    static const std::regex face{R"(@font-face \{[^}]*\}\n?)"};
    return std::regex_replace(style, face, "");
}

std::string style(const Tree &tree) {
    return "<style>\n" + without_typefaces(of_site(tree, "site.css")) + of_site(tree, "play.css") + "</style>\n";
}
std::string script(const std::string &text) { return "<script>\n" + text + "</script>\n"; }

/// The demo's place as chapters have it, without the picture, which lies in a file of its own.
std::string figure(const Demo &demo, DemoMark mark) {
    mark.mine = true;
    return demo_figure({demo.section, mark, {}, ""}, "demo", mark, escaped(demo.about));
}

constexpr const char *head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
)";
constexpr const char *signature =
    R"(<p class="above">I wrote the physics of this, function by function, with <em>Frame by Frame</em>, a course in game
physics. <em>Yours</em> is my code, and <em>Ours</em> is the book's.</p>
)";

} // namespace

std::string shared_page(const Tree &tree, const Demo &demo, const DemoMark &mark, bool with_progress) {
    const std::string name = demo.section.name;
    std::string page = head + ("<title>" + escaped(demo.about) + "</title>\n") + style(tree)
                       + script(of_site(tree, "theme.js")) + "<main>\n" + figure(demo, mark) + signature + "</main>\n"
                       + script(of_site(tree, demo_file(demo.section)))
                       + script(read_file(tree.build / "play" / (name + "_mine.js")));
    if (with_progress) page += script(progress_script(tree));
    for (const char *each : {"draw.js", "hands.js", "play.js"}) page += script(of_site(tree, each));
    return page + "</html>\n";
}

} // namespace course
