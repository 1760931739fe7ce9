#include "site/share.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/markdown.hpp"
#include "site/build.hpp"
#include "site/progress_script.hpp"

#include <fmt/format.h>
#include <regex>

namespace course {
namespace {

std::string of_site(const Workspace &workspace, const std::string &name) {
    return read_file(site_folder(workspace) / name);
}

/// Without the site's own typefaces, which lie in files of their own.
std::string without_typefaces(const std::string &style) {
    static const std::regex face{R"(@font-face \{[^}]*\}\n?)"};
    return std::regex_replace(style, face, "");
}

std::string style(const Workspace &workspace) {
    return "<style>\n" + without_typefaces(of_site(workspace, "site.css")) + of_site(workspace, "play.css")
           + "main { padding-top: 0; }\n</style>\n";
}
std::string script(const std::string &text) { return "<script>\n" + text + "</script>\n"; }

constexpr const char *head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
)";
constexpr const char *signature =
    R"(<p class="above">I wrote the physics of this, function by function, with <em>Frame by Frame</em>, a course in game
physics. Press <em>Mine</em> to see it run on my code, and <em>The book’s</em> to compare.</p>
)";

constexpr const char *sketch_signature =
    R"(<p class="above">I wrote this with <em>Frame by Frame</em>, a course in game physics. Where there's a choice,
<em>Mine</em> calls the course's functions as I wrote them, and <em>The book’s</em> as they are in the book.</p>
)";

constexpr const char *compare =
    R"(<p class="above">Compare <em>{0}</em>, which has the bug in it, with <em>Ours</em>. When you've mended it,
<code>./course play {1} --bug</code> plays it again, and <code>./course bug {1}</code> judges it.</p>
)";

/// The demo's place as chapters have it, without the picture, which is another file.
std::string figure(const Demo &demo, DemoMark mark, const std::string &task) {
    mark.mine = true;
    return demo_figure({demo.section, mark, {}, ""}, "demo", mark, escaped(task));
}

/// The figure with another attribute, which the page's script reads.
std::string with_attribute(const std::string &attribute, const std::string &figure) {
    constexpr std::string_view begin = "<figure";
    return std::string{begin} + ' ' + attribute + figure.substr(begin.size());
}

/// A page with a figure, words below it, and all that it runs.
/// @param compiled  what's played, as elements
std::string page_of(const Workspace &workspace, const std::string &title, const std::string &figure,
                    const std::string &words, const std::string &compiled) {
    std::string page = head + ("<title>" + escaped(title) + "</title>\n") + style(workspace)
                       + script(of_site(workspace, "theme.js")) + "<main>\n" + figure + words + "</main>\n" + compiled;
    for (const char *each : {"draw.js", "answers.js", "play.js"}) page += script(of_site(workspace, each));
    return page + "</html>\n";
}

std::string ours(const Workspace &workspace, const Demo &demo) {
    return script(of_site(workspace, demo_file(demo.section)));
}

} // namespace

std::string shared_page(const Workspace &workspace, const Demo &demo, const DemoMark &mark, bool with_progress) {
    const std::string mine = script(read_file(workspace.build / "play" / (demo.section.name + "_mine.js")));
    return page_of(workspace, demo.about, with_attribute("data-shared", figure(demo, mark, demo.about)), signature,
                   ours(workspace, demo) + (with_progress ? mine + script(progress_script(workspace)) : mine));
}

std::string page_with_bug(const Workspace &workspace, const Demo &demo, const DemoMark &mark) {
    const std::string file = workspace.bug(demo.section).filename().string();
    const std::string named =
        with_attribute("data-yours=\"" + file + '"', figure(demo, mark, words_of(parse_markdown(mark.task).get())));
    return page_of(workspace, demo.about, named, fmt::format(compare, file, demo.section.short_number()),
                   ours(workspace, demo)
                       + script(read_file(workspace.build / "play" / (demo.section.name + "_bug.js"))));
}

std::string sketch_page(const Workspace &workspace, const std::string &name, const std::string &compiled, bool shared) {
    const std::string place = "<figure class=\"play\" id=\"demo\" data-demo=\"" + name + "\" data-mine><figcaption>"
                              + with_capital(name) + "</figcaption></figure>\n";
    if (!shared) return page_of(workspace, name, place, "", compiled);
    return page_of(workspace, name, with_attribute("data-shared", place), sketch_signature, compiled);
}

} // namespace course
