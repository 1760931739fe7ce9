// `course reset`: the empty exercise again. What the student wrote is kept.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "check/catalogue.hpp"
#include "check/own_tests.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"
#include "site/progress_script.hpp"

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

/// @return whether it was done, or there was nothing to do; else the student answered no
bool reset(const Workspace &workspace, const Section &section, const std::string &words, bool tests, bool yes) {
    const std::filesystem::path student_file = tests ? workspace.own_tests(section) : workspace.exercise(section);
    const std::string file = workspace.relative_name(student_file),
                      number = section.short_number() + (tests ? " --tests" : "");
    if (is_number_of_exercise(words))
        throw UserError{"`reset` brings back a whole section, not one exercise of it: ./course reset " + number};

    const std::string empty = tests ? empty_own_tests(workspace, section) : read_file(workspace.stub(section));
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
                        + ", and there is no terminal to ask on; ./course reset " + number
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

} // namespace

void add_reset(CLI::App &app, const Workspace &workspace) {
    const auto section = std::make_shared<std::string>();
    const auto tests = std::make_shared<bool>(), yes = std::make_shared<bool>();
    CLI::App *command =
        app.add_subcommand("reset", "Bring back a section's empty exercises, and its bugs; yours are kept as a copy");
    command->add_option("section", *section, "its number, name or file")->required();
    command->add_flag("--tests", *tests, "your own tests instead, see mytests");
    command->add_flag("--yes", *yes, "do not ask");
    command->footer("The copy goes to .course/kept/, under a name with date and time.\n\nExample: ./course reset 7");
    command->callback([&workspace, section, tests, yes] {
        const Section chosen = workspace.section(*section);
        if (reset(workspace, chosen, *section, *tests, *yes) && !*tests) reset_bugs(workspace, chosen);
        write_progress_script(workspace);
    });
}

} // namespace course
