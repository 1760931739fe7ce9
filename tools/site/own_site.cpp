#include "site/own_site.hpp"

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "book/html.hpp"
#include "check/programs.hpp"
#include "check/progress_store.hpp"
#include "figures/own_figures.hpp"
#include "figures/section_figures.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// "demos/07_lines_mine.js" beside "demos/07_lines.js".
std::string own_demo_script(std::string_view script) {
    return std::string{script.substr(0, script.size() - 3)} + "_mine.js";
}

std::string own_demo_file(const Section &section) { return own_demo_script(demo_file(section)); }

bool has_demo(const Workspace &workspace, const Section &section) {
    return fs::exists(workspace.root / demo_file(section));
}

void write_own_demo(const Workspace &workspace, const Section &section, const std::string &script) {
    write_file(own_site_folder(workspace) / own_demo_file(section), script);
}

/// Where the sentence about a section is kept, for the page of the chapter.
fs::path note_file(const Workspace &workspace, const Section &section) {
    return workspace.build / "mine" / "notes" / (section.name + ".txt");
}

// What is the student's in a section

std::string count_of(std::ptrdiff_t count, const char *one) {
    return count == 1 ? std::string{"one "} + one : std::to_string(count) + ' ' + one + 's';
}

/// So that the sentence can go on.
std::string without_stop(std::string sentence) {
    while (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

/// One sentence of what may be several parts; a question among them ends it.
std::string one_sentence(const std::vector<std::string> &parts) {
    std::string sentence;
    for (const std::string &part : parts)
        if (!part.empty())
            sentence += sentence.empty() ? part : sentence.ends_with('?') ? ' ' + with_capital(part) : "; " + part;
    return sentence;
}

/// What kept figures from being drawn, besides functions that are not started; "" if nothing did.
std::string about_failures(const OwnFigures &own, bool any_drawn) {
    const auto has_failed = [](const OwnFigure &one) { return !one.why_not.empty(); };
    const auto first = std::find_if(own.figures.begin(), own.figures.end(), has_failed);
    const bool stopped = !own.ran.trouble.empty() && !is_only_unfinished(own.ran.finished);
    const std::string trouble = stopped ? without_stop(own.ran.trouble) : "";
    if (first == own.figures.end()) return trouble;
    if (stopped) return trouble + (any_drawn ? "; the other figures stay ours" : "; the figures stay ours");
    const auto others = std::count_if(first + 1, own.figures.end(), has_failed);
    return first->figure.name() + (others == 0 ? " stays" : " and " + count_of(others, "other") + " stay")
           + " ours: " + without_stop(first->why_not);
}

/// "3 figures show your curve; one figure waits for functions that are not started".
std::string about_figures(const OwnFigures &own) {
    const auto drawn = std::ranges::count(own.figures, true, &OwnFigure::drawn);
    const auto waiting = std::ranges::count(own.figures, true, &OwnFigure::not_started);
    const auto some = [](std::ptrdiff_t count, const char *one, const char *many) {
        return count == 0 ? "" : count_of(count, "figure") + (count == 1 ? one : many);
    };
    return one_sentence(
        {some(drawn, " shows your curve", " show your curve"),
         some(waiting, " waits for functions that are not started", " wait for functions that are not started"),
         about_failures(own, drawn > 0)});
}

std::string renewed(const Workspace &workspace, const Section &section) {
    const std::string file = workspace.relative_name(workspace.exercise(section)), number = section.short_number();
    if (!fs::exists(workspace.exercise(section)))
        return file + " is not there, so all stays ours; `./course reset " + number + "` brings the empty one back";
    if (fingerprint(workspace.exercise(section)) == fingerprint(workspace.stub(section)))
        return "not started, so figures and demo are ours";
    draw_figures(workspace, section); // our curves
    const OwnFigures own = draw_own_figures(workspace, section);
    if (!own.ran.started) return without_stop(own.ran.trouble) + "; figures and demo stay ours";
    const std::string figures = about_figures(own);
    if (!has_demo(workspace, section) || !can_compile_demos(workspace))
        return figures.empty() ? "all stays ours" : figures;
    const std::string trouble = build_own_demo(workspace, section);
    if (!trouble.empty()) write_own_demo(workspace, section, ""); // the demo is ours, rather than a sentence
    return one_sentence({figures, trouble.empty() ? "the demo runs your code" : "the demo stays ours: " + trouble});
}

// Pages

/// The sentence as HTML, with what is to be typed as code.
std::string own_paragraph(std::string sentence) {
    static const std::regex typed{"`([^`]*)`"};
    sentence = std::regex_replace(escaped(sentence), typed, "<code class=\"long\">$1</code>");
    if (!sentence.ends_with('.') && !sentence.ends_with('?')) sentence += '.';
    return "\n<p class=\"own\">" + with_capital(sentence) + "</p>";
}

/// What the own copy of a page says of itself; "" if it is like ours.
std::string note_on(const Workspace &workspace, const std::string &page) {
    if (page == "index")
        return own_paragraph(
            "This copy of the book is yours: figures and demos run on what you have written, where you "
            "have begun; `./course site --mine` brings it up to date");
    for (const Section &section : workspace.sections())
        if (page == page_name(workspace, workspace.chapter(section)) && fs::exists(note_file(workspace, section)))
            return own_paragraph(read_file(note_file(workspace, section)));
    return "";
}

/// Whether a picture has a drawing with the student's curve.
bool has_own_drawing(const Workspace &workspace, const fs::path &picture) {
    return picture.parent_path() == "plots" && fs::exists(own_drawing(workspace, {picture, {}, {}}));
}

std::string own_page(const Workspace &workspace, const std::string &page, const std::string &text) {
    std::string out;
    std::size_t copied = 0;
    const auto insert = [&](const char *at, const std::string &words) {
        const auto place = static_cast<std::size_t>(at - text.data());
        out.append(text, copied, place - copied) += words;
        copied = place;
    };
    Tag before{"<>"};
    each_tag(text, [&](const Tag &tag) {
        const char *begin = tag.whole.data(), *end = begin + tag.whole.size();
        const std::string source = before.attribute("src"), name{tag.name()};
        if (name == "main") insert(end, note_on(workspace, page));
        if (before.attribute("class") == "book-name") insert(begin, " <small>your copy</small>");
        if (tag.attribute("class") == "play" && !tag.has("data-mine") && !is_of_gallery(tag.attribute("data-demo")))
            insert(end - 1, " data-mine");
        if (name == "figcaption" && before.name() == "img" && has_own_drawing(workspace, source))
            insert(end, "<strong class=\"own\">With your curve.</strong> ");
        if (before.name() == "script" && source.starts_with("demos/")
            && !is_of_gallery(fs::path{source}.stem().string()))
            insert(end, "\n<script src=\"" + own_demo_script(source) + "\"></script>");
        before = tag;
    });
    return out.append(text, copied);
}

/// The own copy of one of the site's files.
std::string own_copy(const Workspace &workspace, const fs::path &name) {
    if (name.parent_path() == "plots")
        if (const fs::path own = own_drawing(workspace, {name, {}, {}}); fs::exists(own)) return read_file(own);
    const std::string text = read_file(site_folder(workspace) / name);
    return name.extension() == ".html" ? own_page(workspace, name.stem().string(), text) : text;
}

} // namespace

bool can_compile_demos(const Workspace &workspace) { return fs::exists(workspace.build / "play" / "can_compile"); }

std::string build_own_demo(const Workspace &workspace, const Section &section) {
    workspace.written_exercise(section);
    const Finished built = build_target(workspace, section.name + "_play_mine");
    std::string script, trouble;
    if (built.code == 0) script = read_file(workspace.build / "play" / (section.name + "_mine.js"));
    else trouble = student_error(workspace, section, workspace.exercise(section), built.out + '\n' + built.err);
    script += "self.playable = self.playable || {};\nself.playable['" + section.name
              + "/trouble'] = " + nlohmann::json(trouble).dump() + ";\n";
    write_own_demo(workspace, section, script);
    return trouble;
}

std::string renew_own_section(const Workspace &workspace, const Section &section) {
    for (const Figure &figure : figures_of(workspace, section)) fs::remove(own_drawing(workspace, figure));
    if (has_demo(workspace, section)) write_own_demo(workspace, section, "");
    const std::string sentence = renewed(workspace, section);
    write_file(note_file(workspace, section), sentence);
    return sentence;
}

void copy_own_site(const Workspace &workspace) {
    const fs::path from = site_folder(workspace), to = own_site_folder(workspace);
    SiteFiles files;
    for (const auto &entry : fs::recursive_directory_iterator{from}) {
        if (!entry.is_regular_file()) continue;
        const fs::path name = entry.path().lexically_relative(from);
        files[name.generic_string()] = own_copy(workspace, name);
    }
    for (const Section &section : workspace.sections()) {
        if (!has_demo(workspace, section)) continue;
        const fs::path script = to / own_demo_file(section);
        files[own_demo_file(section)] = fs::exists(script) ? read_file(script) : "";
    }
    write_site(to, files);
}

} // namespace course
