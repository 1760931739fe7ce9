// `course run`: a section's program, or one part of it, with our functions or the student's. Its output is unchanged.

#include "commands/commands.hpp"
#include "ground/lock.hpp"
#include "loop/programs.hpp"

#include <iostream>

namespace course {
namespace {

void run_section(const Tree &tree, const Section &section, const std::string &part, Whose whose) {
    if (whose == Whose::reference)
        tree.require_solution(section,
                              "`./course run " + section.short_number() + " --mine` runs the program with yours");
    const std::filesystem::path traces = whose == Whose::student ? student_traces(tree, section)
                                         : tree.is_shared()      ? tree.work() / "traces" / section.name
                                                                 : reference_traces(tree, section);
    const Lock lock{tree};
    const Ran ran = run_program(tree, section, whose, traces, part);
    std::cout << ran.finished.out << std::flush;
    std::cerr << ran.finished.err;
    if (ran.trouble.empty()) {
        if (part.empty()) std::cerr << "The traces of its figures are in " << traces.string() << '\n';
        return;
    }
    std::cerr << "course: " << ran.trouble << '\n';
    throw Leave{whose == Whose::student ? something_to : our_fault};
}

} // namespace

void add_run(CLI::App &app, const Tree &tree) {
    const auto section = std::make_shared<std::string>(), part = std::make_shared<std::string>();
    const auto mine = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("run", "Run a section's program, and print its worked examples");
    command->add_option("section", *section, "its number, name or file")->required();
    command->add_option("part", *part, "one part of its output, as the chapter names it; without it, all of them");
    command->add_flag("--mine", *mine, "with your functions instead of ours");
    command->footer("Example: ./course run 7 --mine\n         ./course run 7 intersections");
    command->callback([&tree, section, part, mine] {
        run_section(tree, tree.section(*section), *part, *mine ? Whose::student : Whose::reference);
    });
}

} // namespace course
