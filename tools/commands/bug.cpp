// `course bug`: one of our functions with a mistake in it, to be found and mended; then the law that it broke is named.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "check/bugs.hpp"
#include "check/catalogue.hpp"
#include "check/judge.hpp"
#include "check/progress.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <iostream>

namespace course {
namespace {

namespace fs = std::filesystem;

constexpr const char *about_bug = R"(
Each section has three bugs, from obvious to mean. Type it once, and the bug is in exercises/08_bug.cpp; play with
it, mend it, and type it again: it says how many tests are still red, and in the end asks which law the bug broke.
Delete the file, and the bug comes back as it was.

Example: ./course bug 8
         ./course play 8 --bug
         ./course bug 8 --law B)";

struct BugOptions {
    std::string section, law;
    bool again = false, verbose = false;
};

char letter(std::size_t law) { return static_cast<char>('A' + law); }

/// A section's bugs, and how far the student is with them.
class Bugs {
  public:
    Bugs(const Workspace &tree_, BugOptions options_)
        : workspace{tree_},
          options{std::move(options_)},
          section{workspace.section(options.section)},
          bugs{bugs_of(workspace, section)},
          hunt{recall_hunt(workspace, section)},
          file{workspace.bug(section)},
          again{"./course bug " + section.short_number()} {
        if (is_number_of_exercise(options.section)) throw UserError{"bugs come a section at a time: type " + again};
        if (bugs.empty()) throw UserError{"section " + section.short_number() + " has no bugs to hunt yet"};
    }

    int hunt_on() {
        if (options.again) hunt.found.clear(), hunt.begun.clear();
        const auto open = next();
        if (open == bugs.end()) {
            std::cout << "You've found all " << bugs.size() << " bugs of section " << section.short_number()
                      << ". They come back with: " << again << " --again\n";
            return all_well;
        }
        if (hunt.begun == open->name && fs::exists(file)) return look_at(*open);
        if (!options.law.empty()) throw UserError{"there's no bug to name a law of yet: " + again + " puts one there"};
        begin(*open);
        return all_well;
    }

  private:
    static constexpr unsigned seed = 2026; // as `check` has it

    std::vector<Bug>::const_iterator next() const {
        return std::ranges::find_if(bugs, [&](const Bug &bug) { return !hunt.found.contains(bug.name); });
    }

    /// "bug 2 of 3"
    std::string place_of(const Bug &bug) const {
        return "bug " + std::to_string(&bug - bugs.data() + 1) + " of " + std::to_string(bugs.size());
    }

    Exercise exercise_of(const Bug &bug) const { return find_exercise(workspace, bug.exercise).exercise; }

    /// What the bug's file is.
    std::string text_of(const Bug &bug) const {
        const std::string number = section.short_number();
        return "// Section " + number + ", " + place_of(bug) + ": our `" + exercise_of(bug).function
               + "`, and what it calls, with one mistake.\n// See what goes wrong: ./course play " + number
               + " --bug  Then find it, mend it, save, and type: " + again + "\n\n"
               + code_of(workspace, section, bug).text;
    }

    void begin(const Bug &bug) {
        const std::string text = text_of(bug);
        if (const fs::path copy = keep_copy_of_bug(workspace, section); !copy.empty())
            std::cout << "What you had in " << workspace.relative_name(file)
                      << " is kept: " << workspace.relative_name(copy) << '\n';
        write_file(file, text);
        hunt.begun = bug.name;
        hunt.written = fingerprint(file);
        remember_hunt(workspace, section, hunt);
        std::cout << with_capital(place_of(bug)) << " is in " << workspace.relative_name(file) << ": our "
                  << bug.exercise << ' ' << exercise_of(bug).function << ", with one mistake in it.\n"
                  << (is_passed(bug)
                          ? ""
                          : "You haven't passed " + bug.exercise
                                + " yet, and this gives most of it away: you may want to write yours first.\n")
                  << "See what goes wrong: ./course play " << section.short_number() << " --bug\n"
                  << "Mend the file, save it, and type " << again << " again.\n";
    }

    bool is_passed(const Bug &bug) const {
        const Progress known = progress(workspace, section);
        return std::ranges::any_of(known.standings, [&](const Standing &each) {
            return each.exercise.number == bug.exercise && each.state == "passed";
        });
    }

    int look_at(const Bug &bug) {
        const JudgeResult judgement = judge(workspace, section, file, {seed, bug.exercise});
        const auto all = std::ssize(judgement.verdicts),
                   red = all - std::ranges::count_if(judgement.verdicts, &Verdict::passed);
        if (judgement.all_passed()) return name_law(bug, all);
        if (judgement.unbuilt || judgement.our_fault() || options.verbose)
            return check_file(workspace, bug.exercise, file);
        if (fingerprint(file) == hunt.written)
            std::cout << "You haven't changed " << workspace.relative_name(file) << " yet.\n";
        std::cout << painted(Colour::red,
                             "✗ " + std::to_string(red) + " of " + pluralize(all, "test") + " of " + bug.exercise)
                  << (red == 1 ? " is" : " are") << " red. Play with it: ./course play " << section.short_number()
                  << " --bug. Or see the tests: " << again << " -v\n";
        return something_to;
    }

    int name_law(const Bug &bug, std::ptrdiff_t all) {
        if (options.law.empty()) {
            std::cout
                << painted(Colour::green, "✓ All " + pluralize(all, "test") + " of " + bug.exercise + " are green:")
                << " it's mended.\nWhich law did the bug break? Three of these were green with it, and one was red:\n";
            for (std::size_t i = 0; i < bug.laws.size(); ++i)
                std::cout << "  " << painted(Colour::bold, std::string{letter(i)}) << "  " << bug.laws[i] << '\n';
            std::cout << "Say which, as in: " << again << " --law A\n";
            return all_well;
        }
        const std::string &law = bug.laws[chosen_of(bug)];
        if (law != bug.broken) {
            std::cout << painted(Colour::red, "No:") << " the bug left that one green: " << law
                      << ".\nLook at the line that you changed. What came out before, and what had to?\n";
            return something_to;
        }
        finish(bug);
        return all_well;
    }

    /// The place of the law that was named.
    std::size_t chosen_of(const Bug &bug) const {
        const char given = with_capital(options.law)[0];
        if (options.law.size() != 1 || given < 'A' || given >= letter(bug.laws.size()))
            throw UserError{"--law wants one of the letters A to " + std::string{letter(bug.laws.size() - 1)}
                            + ", not `" + options.law + '`'};
        return static_cast<std::size_t>(given - 'A');
    }

    void finish(const Bug &bug) {
        hunt.found.insert(bug.name);
        remember_hunt(workspace, section, hunt);
        const std::string claim = code_of(workspace, section, bug).claim;
        std::cout << painted(Colour::green, "Right: ") << bug.broken << ".\nIt breaks when " << claim
                  << (claim.ends_with('?') ? "" : ".") << '\n';
        if (next() == bugs.end())
            std::cout << "That was the last of the " << bugs.size() << " bugs of section " << section.short_number()
                      << ".\n";
        else std::cout << "That's " << place_of(bug) << ". The next one: " << again << '\n';
    }

    const Workspace &workspace;
    BugOptions options;
    Section section;
    std::vector<Bug> bugs;
    Hunt hunt;
    fs::path file;
    std::string again; ///< what to type to go on
};

} // namespace

void add_bug(CLI::App &app, const Workspace &workspace) {
    const auto options = std::make_shared<BugOptions>();
    CLI::App *command = app.add_subcommand("bug", "Hunt a bug: our function with a mistake in it, for you to mend");
    command->add_option("section", options->section, "its number, name or file")->required();
    command->add_option("--law", options->law, "once it's mended: the law that the bug broke")->type_name("LETTER");
    command->add_flag("-v,--verbose", options->verbose, "show which tests are still red");
    command->add_flag("--again", options->again, "begin again with the first bug");
    command->footer(about_bug);
    command->callback([&workspace, options] {
        if (const int code = Bugs{workspace, *options}.hunt_on(); code != all_well) throw ExitRequest{code};
    });
}

} // namespace course
