// `course run`: a section's program, or one part of it, with our functions or the student's. Its output is unchanged.

#include "base/lock.hpp"
#include "check/programs.hpp"
#include "commands/commands.hpp"

#include <iostream>

namespace course {
namespace {

void run_section(const Workspace &workspace, const Section &section, const std::string &part, Whose functions) {
    if (functions == Whose::reference)
        workspace.require_solution(section,
                                   "`./course run " + section.short_number() + " --mine` runs the program with yours");
    const std::filesystem::path traces =
        functions == Whose::student ? student_traces(workspace, section) : reference_traces(workspace, section);
    const Lock lock{workspace};
    const Ran ran = run_program(workspace, section, functions, traces, part);
    std::cout << ran.finished.out << std::flush;
    std::cerr << ran.finished.err;
    if (ran.trouble.empty()) {
        if (part.empty()) std::cerr << "The traces of its figures are in " << traces.string() << '\n';
        return;
    }
    std::cerr << "course: " << ran.trouble << '\n';
    throw ExitRequest{functions == Whose::student ? something_to : our_fault};
}

} // namespace

void add_run(CLI::App &app, const Workspace &workspace) {
    const auto section = std::make_shared<std::string>(), part = std::make_shared<std::string>();
    const auto mine = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("run", "Run a section's program, and print its worked examples");
    command->add_option("section", *section, "its number, name or file")->required();
    command->add_option("part", *part, "one part of its output, as the chapter names it; without it, all of them");
    command->add_flag("--mine", *mine, "with your functions instead of ours");
    command->footer("Example: ./course run 7 --mine\n         ./course run 7 intersections");
    command->callback([&workspace, section, part, mine] {
        run_section(workspace, workspace.section(*section), *part, *mine ? Whose::student : Whose::reference);
    });
}

} // namespace course
