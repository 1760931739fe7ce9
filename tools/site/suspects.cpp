#include "site/suspects.hpp"

#include "book/chapter.hpp"
#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "loop/bugs.hpp"
#include "site/demos.hpp"
#include "site/html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace course {
namespace {

std::string choice(const std::string &name, std::size_t value, const std::string &words) {
    return fmt::format("<label><input type=\"radio\" name=\"{}\" value=\"{}\" required> <span>{}</span></label>", name,
                       value, words);
}

/// The bug that is shown, if there is one.
std::optional<Bug> shown_bug(const Tree &tree, const Section &section) try {
    for (const Bug &bug : bugs_of(tree, section))
        if (!bug.others.empty()) return bug;
    return {};
} catch (const Complaint &) {
    return {};
} // without answers

/// As at the exercise's box, but for what the bug needs to be seen.
DemoMark place_of(const Tree &tree, const Bug &bug, const Demo &demo) {
    const std::vector<DemoMark> marks = demo_marks(read_file(tree.chapter(demo.section)));
    const auto there = std::ranges::find(marks, bug.exercise, &DemoMark::exercise);
    DemoMark mark = there == marks.end() ? demo.mark : *there;
    if (!bug.place.empty()) mark.start = bug.place;
    mark.mine = false;
    return mark;
}

std::string two_of(const Tree &tree, const Demo &demo, const Bug &bug, const std::string &function) {
    const DemoMark mark = place_of(tree, bug, demo);
    const Causes causes = causes_of(tree, demo.section, bug);
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

std::string suspects(const Tree &tree, const std::filesystem::path &chapter) {
    for (const Demo &demo : demos(tree))
        if (tree.chapter(demo.section) == chapter)
            if (const auto bug = shown_bug(tree, demo.section))
                for (const ListedExercise &one : declared_exercises(read_file(tree.header(demo.section))))
                    if (one.number == bug->exercise) return two_of(tree, demo, *bug, one.function);
    return "";
}

} // namespace course
