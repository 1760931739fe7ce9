// `course reset`: the empty exercise again. What the student wrote is kept.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/terminal.hpp"
#include "loop/catalogue.hpp"
#include "loop/memory.hpp"
#include "loop/own_tests.hpp"
#include "site/progress_script.hpp"

#include <iostream>

namespace course {
namespace {

/// No bug has been found, and none is there to be mended.
void reset_bugs(const Tree &tree, const Section &section) {
    const std::string file = tree.shown(tree.bug(section));
    const std::filesystem::path copy = keep_copy_of_bug(tree, section);
    const bool was_there = std::filesystem::remove(tree.bug(section));
    if (!recall_hunt(tree, section).begun.empty()) remember_hunt(tree, section, {});
    if (!copy.empty()) std::cout << file << " is gone. Yours is kept: " << tree.shown(copy) << '\n';
    else if (was_there) std::cout << file << " is gone.\n";
}

/// @return whether it was done, or there was nothing to do; else the student said no
bool reset(const Tree &tree, const Section &section, const std::string &words, bool tests, bool yes) {
    const std::filesystem::path theirs = tests ? tree.own_tests(section) : tree.exercise(section);
    const std::string file = tree.shown(theirs), number = section.short_number() + (tests ? " --tests" : "");
    if (is_number_of_exercise(words))
        throw Complaint{"`reset` brings back a whole section, not one exercise of it: ./course reset " + number};

    const std::string empty = tests ? empty_own_tests(tree, section) : read_file(tree.stub(section));
    if (!std::filesystem::exists(theirs)) {
        write_file(theirs, empty);
        std::cout << file << " is back, with nothing done yet.\n";
        return true;
    }
    if (read_file(theirs) == empty) {
        std::cout << file << " is the empty one already.\n";
        return true;
    }
    if (!yes && !can_ask())
        throw Complaint{"`reset` asks before it replaces " + file
                        + ", and there is no terminal to ask on; ./course reset " + number
                        + " --yes does it, and keeps a copy"};
    if (!yes && !ask("Replace " + file + " by the empty one? Yours is kept in .course/kept.")) {
        std::cout << "Nothing has changed.\n";
        return false;
    }
    const std::filesystem::path copy = keep_copy(tree, theirs);
    write_file(theirs, empty);
    std::cout << file << " is the empty one again. Yours is kept: " << tree.shown(copy) << '\n';
    return true;
}

} // namespace

void add_reset(CLI::App &app, const Tree &tree) {
    const auto section = std::make_shared<std::string>();
    const auto tests = std::make_shared<bool>(), yes = std::make_shared<bool>();
    CLI::App *command =
        app.add_subcommand("reset", "Bring back a section's empty exercises, and its bugs; yours are kept as a copy");
    command->add_option("section", *section, "its number, name or file")->required();
    command->add_flag("--tests", *tests, "your own tests instead, see mytests");
    command->add_flag("--yes", *yes, "do not ask");
    command->footer("The copy goes to .course/kept/, under a name with date and time.\n\nExample: ./course reset 7");
    command->callback([&tree, section, tests, yes] {
        const Section chosen = tree.section(*section);
        if (reset(tree, chosen, *section, *tests, *yes) && !*tests) reset_bugs(tree, chosen);
        tell_pages(tree);
    });
}

} // namespace course
