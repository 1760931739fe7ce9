// `course debug`: the same tests, with the student's code in the same process, under a debugger.

#include "base/build.hpp"
#include "base/lock.hpp"
#include "base/process.hpp"
#include "base/terminal.hpp"
#include "check/catalogue.hpp"
#include "commands/commands.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <regex>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;
namespace {

/// The debugger on our tests; for one exercise: on its tests, and stopping where its function begins.
std::vector<std::string> debugger(const fs::path &program, const std::string &function, const std::string &tag) {
    std::vector<std::string> command;
    if (in_path("gdb")) {
        command = {"gdb", "-q"};
        if (!function.empty()) command.insert(command.end(), {"-ex", "break " + function});
        command.push_back("--args");
    } else if (in_path("lldb")) {
        command = {"lldb"};
        if (!function.empty()) command.insert(command.end(), {"-o", "breakpoint set --name " + function});
        command.push_back("--");
    } else {
        throw UserError{"there is no debugger here: install gdb (or lldb). The program to debug is "
                        + program.string()};
    }
    command.push_back(program.string());
    if (!tag.empty()) command.push_back(tag);
    return command;
}

/// As it can be typed into a shell.
std::string typed(const std::vector<std::string> &command) {
    static const std::regex harmless{R"([A-Za-z0-9_./:=+-]+)"};
    std::string line;
    for (const std::string &word : command)
        line += (line.empty() ? "" : " ")
                + (std::regex_match(word, harmless) ? word
                                                    : "'" + std::regex_replace(word, std::regex{"'"}, "'\\''") + "'");
    return line;
}

void build(const Workspace &workspace, const Section &section) {
    const Lock lock{workspace};
    const Finished built = build_target(workspace, section.name + "_debug");
    if (built.code == 0) return;
    std::cerr << built.out << built.err
              << "course: this does not compile, so there is nothing to debug yet; ./course check "
              << section.short_number() << " shows the first error\n";
    throw ExitRequest{something_to};
}

void debug(const Workspace &workspace, const std::string &words, bool print) {
    std::string function, tag;
    Section section = workspace.section(words);
    if (is_number_of_exercise(words)) {
        const Exercise exercise = find_exercise(workspace, words).exercise;
        function = section.slug() + "::" + exercise.function;
        tag = "[" + exercise.number + "]";
    }
    workspace.written_exercise(section);
    build(workspace, section);
    const auto command = debugger(workspace.build / "debug" / section.name, function, tag);
    if (print || !can_ask() || !is_terminal()) {
        std::cout << typed(command) << '\n';
        return;
    }
    std::cerr << typed(command) << "\nType `run` to start, `where` to see where it stopped, `quit` to leave.\n";
    std::vector<char *> arguments;
    for (const std::string &word : command) arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    throw UserError{"cannot start " + command.front() + " (" + std::strerror(errno) + ")"};
}

} // namespace

void add_debug(CLI::App &app, const Workspace &workspace) {
    const auto section = std::make_shared<std::string>();
    const auto print = std::make_shared<bool>();
    CLI::App *command =
        app.add_subcommand("debug", "Build the tests with your code in one process, and start a debugger");
    command->add_option("section", *section, "its number, name or file, or one exercise: 7.2")->required();
    command->add_flag("--print", *print, "only print the debugger's command");
    command->footer("Without a terminal the command is printed as well.\n\nExample: ./course debug 7.2");
    command->callback([&workspace, section, print] { debug(workspace, *section, *print); });
}

} // namespace course
