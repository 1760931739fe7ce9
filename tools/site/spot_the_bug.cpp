#include "site/spot_the_bug.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/chapter.hpp"
#include "book/html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace course {
namespace {

std::string choice(const std::string &name, std::size_t value, const std::string &words) {
    return fmt::format("<label><input type=\"radio\" name=\"{}\" value=\"{}\" required> <span>{}</span></label>", name,
                       value, words);
}

/// The bug of this section for the page, if there is one.
std::optional<Bug> shown_bug(const Workspace &workspace, const Section &section) {
    if (!workspace.has_answers(section)) return {};
    for (const Bug &bug : bugs_of(workspace, section))
        if (!bug.others.empty()) return bug;
    return {};
}

std::string two_of(const Workspace &workspace, const Demo &demo, const Bug &bug, const std::string &function) {
    DemoMark mark = place_of_bug(workspace, demo.section, bug);
    mark.mine = false;
    const Causes causes = causes_of(workspace, demo.section, bug);
    const std::string name = escaped(bug.exercise + ' ' + function);
    std::string html =
        fmt::format(R"(<div class="suspects" data-bug="{0}" data-cause="{1}" hidden><p>In one of these two, )"
                    R"(<code>{0}</code> has a bug. Which one, and why?</p><div>)",
                    name, causes.right);
    for (const std::string letter : {"A", "B"}) html += demo_figure(demo, "suspect-" + letter, mark, letter);
    html += "</div><form><fieldset><legend>Which one has the bug?</legend>" + choice("which", 0, "A")
            + choice("which", 1, "B") + "</fieldset><fieldset><legend>It’s what comes out when …</legend>";
    for (std::size_t i = 0; i < causes.all.size(); ++i) html += choice("why", i, escaped(causes.all[i]));
    return html
           + fmt::format(
               R"(</fieldset><button>Check</button><p role="status"></p><p class="told" hidden>It breaks this )"
               R"(law: <em>{}</em>.</p></form></div>)",
               escaped(bug.broken));
}

} // namespace

DemoMark place_of_bug(const Workspace &workspace, const Section &section, const Bug &bug) {
    const std::vector<DemoMark> marks = demo_marks(read_file(workspace.chapter(section)));
    const auto place = std::ranges::find(marks, bug.place, &DemoMark::start);
    return !bug.place.empty() && place != marks.end() ? *place : marks[place_for(marks, bug.exercise, true)];
}

std::string spot_the_bug(const Workspace &workspace, const Demo &demo) {
    if (const auto bug = shown_bug(workspace, demo.section))
        for (const ListedExercise &one : declared_exercises(read_file(workspace.header(demo.section))))
            if (one.number == bug->exercise) return two_of(workspace, demo, *bug, one.function);
    return "";
}

} // namespace course
