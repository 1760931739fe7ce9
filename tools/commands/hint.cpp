// `course hint`: an exercise's hints, one rung at a time, as the chapter has them.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "book/chapter.hpp"
#include "check/catalogue.hpp"
#include "check/progress.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"

#include <iostream>

namespace course {
namespace {

struct HintOptions {
    std::string exercise;
    bool all = false, again = false;
};

std::vector<Hint> rungs_of(const Workspace &workspace, const FoundExercise &exercise) {
    std::vector<Hint> rungs;
    for (Hint &hint : hints(read_file(workspace.chapter(exercise.section))))
        if (hint.number == exercise.exercise.number) rungs.push_back(std::move(hint));
    return rungs;
}

void print(const Hint &hint, int rung, int rungs) {
    const std::string heading =
        hint.number + ", hint " + std::to_string(rung) + " of " + std::to_string(rungs) + ": " + hint.title;
    std::cout << painted(Colour::bold, heading) << "\n\n" << hint.text << (hint.text.ends_with('\n') ? "\n" : "\n\n");
}

/// The exercise to go on with.
FoundExercise next_exercise(const Workspace &workspace) {
    const auto section = section_to_go_on_with(workspace);
    if (!section) throw UserError{"all exercises pass; name one to see its hints, as in: ./course hint 1.2"};
    const Progress known = progress(workspace, *section);
    if (const Standing *next = known.next()) return {*section, next->exercise};
    throw UserError{"all of section " + section->short_number() + " passed when it was last checked; check it again"};
}

void show_hint(const Workspace &workspace, const HintOptions &options) {
    const FoundExercise exercise =
        options.exercise.empty() ? next_exercise(workspace) : find_exercise(workspace, options.exercise);
    const std::string &number = exercise.exercise.number;
    const std::string solution = workspace.has_solution(exercise.section)
                                     ? "`./course solution " + number + "` shows ours."
                                     : "Still stuck? Ask your instructor.";
    const std::vector<Hint> rungs = rungs_of(workspace, exercise);
    const int last = static_cast<int>(rungs.size());
    if (last == 0) {
        std::cout << number << " has no hints: all it needs is in its chapter. " << solution << '\n';
        return;
    }
    if (options.again) remember_rungs(workspace, number, 0);
    if (options.all) remember_rungs(workspace, number, last);
    const int first = options.all ? 0 : take_rung(workspace, number, last), until = options.all ? last : first + 1;
    if (first == last) {
        std::cout << "You have seen all hints of " << number << "; `./course hint " << number
                  << " --all` shows them again. " << solution << '\n';
        return;
    }
    for (int rung = first; rung < until; ++rung) print(rungs[static_cast<std::size_t>(rung)], rung + 1, last);
    if (until == last) std::cout << "That was the last one. " << solution << '\n';
    else std::cout << "The next one: ./course hint " << number << '\n';
}

} // namespace

void add_hint(CLI::App &app, const Workspace &workspace) {
    const auto options = std::make_shared<HintOptions>();
    CLI::App *command = app.add_subcommand("hint", "Show the next hint for an exercise: each time a little more");
    command->add_option("exercise", options->exercise,
                        "its number or its function; nothing: the first that you have not finished");
    command->add_flag("--all", options->all, "all of them at once");
    command->add_flag("--again", options->again, "begin again with the first");
    command->footer("Example: ./course hint 7.2");
    command->callback([&workspace, options] { show_hint(workspace, *options); });
}

} // namespace course
