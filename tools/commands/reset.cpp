// `course reset`: the empty exercise again. What the student wrote is kept.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "check/catalogue.hpp"
#include "check/own_tests.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"
#include "site/progress_script.hpp"

#include <algorithm>
#include <iostream>

namespace course {
namespace {

/// Forgets the hunt, and takes the bug away.
void reset_bugs(const Workspace &workspace, const Section &section) {
    const std::string file = workspace.relative_name(workspace.bug(section));
    const std::filesystem::path copy = keep_copy_of_bug(workspace, section);
    const bool was_there = std::filesystem::remove(workspace.bug(section));
    if (!recall_hunt(workspace, section).begun.empty()) remember_hunt(workspace, section, {});
    if (!copy.empty()) std::cout << file << " is gone. Yours is kept: " << workspace.relative_name(copy) << '\n';
    else if (was_there) std::cout << file << " is gone.\n";
}

/// @param call  what repeats it, without a question: "7 --tests"
/// @return whether it was done, or there was nothing to do; else the student answered no
bool reset(const Workspace &workspace, const std::filesystem::path &student_file, const std::string &empty,
           const std::string &call, bool yes) {
    const std::string file = workspace.relative_name(student_file);
    if (!std::filesystem::exists(student_file)) {
        write_file(student_file, empty);
        std::cout << file << " is back, with nothing done yet.\n";
        return true;
    }
    if (read_file(student_file) == empty) {
        std::cout << file << " is the empty one already.\n";
        return true;
    }
    if (!yes && !can_ask())
        throw UserError{"`reset` asks before it replaces " + file
                        + ", and there is no terminal to ask on; ./course reset " + call
                        + " --yes does it, and keeps a copy"};
    if (!yes && !ask("Replace " + file + " by the empty one? Yours is kept in .course/kept.")) {
        std::cout << "Nothing has changed.\n";
        return false;
    }
    const std::filesystem::path copy = keep_copy(workspace, student_file);
    write_file(student_file, empty);
    std::cout << file << " is the empty one again. Yours is kept: " << workspace.relative_name(copy) << '\n';
    return true;
}

void reset_sketch(const Workspace &workspace, const std::string &name, bool yes) {
    const auto sketches = files_in(workspace.sketches(), ".cpp");
    const auto file =
        std::ranges::find(sketches, name, [](const std::filesystem::path &each) { return each.stem().string(); });
    if (file == sketches.end())
        throw UserError{"there is no sketch `" + name + "`; ./course sketch shows those that are there"};
    reset(workspace, *file, first_sketch(name), name + " --sketch", yes);
}

void reset_section(const Workspace &workspace, const std::string &words, bool tests, bool yes) {
    const Section section = workspace.section(words);
    const std::string call = section.short_number() + (tests ? " --tests" : "");
    if (is_number_of_exercise(words))
        throw UserError{"`reset` brings back a whole section, not one exercise of it: ./course reset " + call};
    if (tests) reset(workspace, workspace.own_tests(section), empty_own_tests(workspace, section), call, yes);
    else if (reset(workspace, workspace.exercise(section), read_file(workspace.stub(section)), call, yes))
        reset_bugs(workspace, section);
    write_progress_script(workspace);
}

} // namespace

void add_reset(CLI::App &app, const Workspace &workspace) {
    const auto what = std::make_shared<std::string>();
    const auto tests = std::make_shared<bool>(), sketch = std::make_shared<bool>(), yes = std::make_shared<bool>();
    CLI::App *command =
        app.add_subcommand("reset", "Bring back a section's empty exercises, and its bugs; yours are kept as a copy");
    command->add_option("section", *what, "its number, name or file")->required();
    CLI::Option *with_tests = command->add_flag("--tests", *tests, "your own tests instead, see mytests");
    command->add_flag("--sketch", *sketch, "the sketch of that name instead")->excludes(with_tests);
    command->add_flag("--yes", *yes, "do not ask");
    command->footer("The copy goes to .course/kept/, under a name with date and time.\n\nExample: ./course reset 7\n"
                    "         ./course reset moon --sketch");
    command->callback([&workspace, what, tests, sketch, yes] {
        if (*sketch) reset_sketch(workspace, *what, *yes);
        else reset_section(workspace, *what, *tests, *yes);
    });
}

} // namespace course
