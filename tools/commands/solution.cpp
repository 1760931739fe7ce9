// `course solution`: our solution of one exercise. Help is never locked away.

#include "book/chapter.hpp"
#include "check/catalogue.hpp"
#include "check/others.hpp"
#include "commands/commands.hpp"

#include <iostream>

namespace course {
namespace {

void show_solution(const Workspace &workspace, const std::string &words) {
    const FoundExercise exercise = find_exercise(workspace, words);
    workspace.require_solution(exercise.section, "`./course hint " + exercise.exercise.number + "` gives you a hint");
    const char *between = "";
    for (const Chunk &chunk : solution(workspace, exercise.section, exercise.exercise.number)) {
        std::cout << between;
        for (std::size_t line = 1; line < chunk.lines.size(); ++line)
            std::cout << chunk.lines[line] << '\n'; // 0: the chunk's mark
        between = "\n";
    }
}

void show_others(const Workspace &workspace, const std::string &words) {
    const FoundExercise exercise = find_exercise(workspace, words);
    const std::string &number = exercise.exercise.number;
    const std::vector<OtherAnswer> others = other_answers(workspace, exercise.section, number);
    if (others.empty()) throw UserError{"this course has no other answers to " + number + "."};
    const char *between = "";
    for (const auto &[claim, code] : others) {
        std::cout << between << "// " << claim << '\n' << code;
        between = "\n";
    }
}

} // namespace

void add_solution(CLI::App &app, const Workspace &workspace) {
    const auto exercise = std::make_shared<std::string>();
    CLI::App *command = app.add_subcommand("solution", "Show our solution of an exercise");
    command->add_option("exercise", *exercise, "its number or its function")->required();
    const auto others = std::make_shared<bool>();
    command->add_flag("--others", *others, "up to three right answers that are written differently");
    command->footer(
        "Yours may look different and be just as right: ./course check judges.\n\nExample: ./course solution 7.2");
    command->callback([&workspace, exercise, others] {
        if (*others) show_others(workspace, *exercise);
        else show_solution(workspace, *exercise);
    });
}

} // namespace course
