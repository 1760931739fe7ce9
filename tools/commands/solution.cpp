// `course solution`: our solution of one exercise. Help is never locked away.

#include "book/chapter.hpp"
#include "commands/commands.hpp"
#include "loop/catalogue.hpp"

#include <iostream>

namespace course {
namespace {

void show_solution(const Tree &tree, const std::string &words) {
    const FoundExercise found = find_exercise(tree, words);
    tree.require_solution(found.section, "`./course hint " + found.exercise.number + "` gives you a hint");
    const char *between = "";
    for (const Chunk &chunk : solution(tree, found.section, found.exercise.number)) {
        std::cout << between;
        for (std::size_t line = 1; line < chunk.lines.size(); ++line)
            std::cout << chunk.lines[line] << '\n'; // 0: its mark
        between = "\n";
    }
}

} // namespace

void add_solution(CLI::App &app, const Tree &tree) {
    const auto exercise = std::make_shared<std::string>();
    CLI::App *command = app.add_subcommand("solution", "Show our solution of an exercise");
    command->add_option("exercise", *exercise, "its number or its function")->required();
    command->footer(
        "Yours may look different and be just as right: ./course check judges.\n\nExample: ./course solution 7.2");
    command->callback([&tree, exercise] { show_solution(tree, *exercise); });
}

} // namespace course
