#include "check/programs.hpp"

#include "base/build.hpp"
#include "base/kernel.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/diagnosis.hpp"
#include "judge/runner/sandbox.hpp"

#include <cmath>
#include <csignal>
#include <sstream>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;

fs::path reference_traces(const Workspace &workspace, const Section &section) {
    return workspace.has_solution(section) ? workspace.build / "traces" / section.name : workspace.root / "plots";
}

fs::path student_traces(const Workspace &workspace, const Section &section) {
    return workspace.build / "mine" / "traces" / section.name;
}

fs::path program_binary(const Workspace &workspace, const Section &section, Whose owner) {
    return owner == Whose::student ? workspace.build / "mine" / section.name
                                   : workspace.build / "chapters" / section.name;
}

std::string trace_message(const Finished &finished, const std::string &trace) {
    std::istringstream lines{finished.err};
    for (std::string line; std::getline(lines, line);)
        for (const std::string kind : {"not started: ", "error: "})
            if (line.starts_with(kind + trace + ": ")) return kind + line.substr(kind.size() + trace.size() + 2);
    return "";
}

bool is_only_unfinished(const Finished &finished) {
    return finished.code == 1 && !finished.timed_out && contains(finished.err, "not started: ")
           && !contains(finished.err, "error: ");
}

std::string last_line(const std::string &text) {
    const auto end = text.find_last_not_of(" \r\n");
    if (end == std::string::npos) return "";
    const auto start = text.find_last_of('\n', end);
    return text.substr(start + 1, end - start); // npos + 1 is 0
}

std::vector<std::string> program_command(const fs::path &program, const std::string &part, const fs::path &traces) {
    std::vector<std::string> command{program.string()};
    if (!part.empty()) command.push_back(part);
    command.insert(command.end(), {"--out", traces.string()});
    return command;
}

std::string student_error(const Workspace &workspace, const Section &section, const fs::path &file,
                          const std::string &printed) {
    const std::string name = workspace.relative_name(file);
    Verdict verdict = diagnose_compiler(printed, file, name, {}, renamed(workspace, section));
    if (verdict.line == 0) verdict = diagnose_linker(printed, name, section.short_number());
    return (verdict.line == 0 ? "" : verdict.file + ':' + std::to_string(verdict.line) + ": ") + verdict.sentence;
}

namespace {

/// How a student's program ended, if not well. A part that could not run has reported it already: chapters/program.hpp.
std::string student_trouble(const Section &section, const Finished &finished, double deadline) {
    const std::string check = "`./course check " + section.short_number() + "`";
    if (finished.timed_out)
        return "your program was stopped after " + std::to_string(std::lround(deadline)) + " s, it wouldn't end; "
               + check + " says which function it is in";
    if (finished.code > 128)
        return "your program " + meaning_of_signal(finished.code - 128) + "; " + check + " says in which function";
    if (finished.code == 0) return "";
    if (finished.code == 1 && contains(finished.err, "error: "))
        return "some parts of the program failed, because one of your functions threw, perhaps at what another one had "
               "answered; "
               + check + " shows what is wrong";
    if (is_only_unfinished(finished))
        return "some parts of the program need functions that aren't started; " + check + " shows which";
    const std::string last = last_line(finished.err);
    return "your program stopped with exit code " + std::to_string(finished.code)
           + (last.empty() ? " and printed no error" : ", and the last line it printed was \"" + last + "\"") + "; "
           + check + " shows what is wrong";
}

/// An empty folder, so that no trace of an earlier run is taken for one of this run.
void empty_folder(const fs::path &folder) {
    std::error_code trouble;
    fs::remove_all(folder, trouble);
    fs::create_directories(folder, trouble);
    if (trouble)
        throw UserError{"cannot write " + folder.string() + ": " + trouble.message()
                        + "; make the build folder writable, or run this as its owner."};
}

/// So that a runaway function cannot bring the machine down. Sanitizers take addresses of many TB.
constexpr Limits student_limits{.memory = sanitized ? 0 : std::size_t{4} << 30, .file_size = std::size_t{100} << 20};
/// A busy machine makes a program wait: the deadline is of computing, and it may take so many times as long.
constexpr double busy = 6;

} // namespace

Ran run_program(const Workspace &workspace, const Section &section, Whose owner, const fs::path &folder,
                const std::string &part, double deadline) {
    const fs::path traces = fs::absolute(folder), program = program_binary(workspace, section, owner);
    const bool student = owner == Whose::student;
    if (student) workspace.written_exercise(section);
    const Finished built = build_target(workspace, section.name + (student ? "_mine" : ""));
    const std::string printed = built.out + '\n' + built.err;
    if (built.code != 0)
        return {false,
                {},
                student ? "your program can't be built: "
                              + student_error(workspace, section, workspace.exercise(section), printed)
                        : "the program of " + section.name + " cannot be built: " + first_error(printed)};
    Finished finished;
    if (student) {
        empty_folder(traces);
        AllowedPaths places{system_paths(), {traces}};
        places.readable.push_back(program);
        const Sandbox sandbox{places, {}};
        // The folder is named by no path: on the way may be others, where root's capabilities are needed.
        Limits limits = student_limits;
        limits.processor_time = static_cast<unsigned>(std::ceil(deadline));
        finished =
            run(program_command(program, part, "."), {.deadline = busy * deadline,
                                                      .idle_limit = deadline,
                                                      .folder = traces,
                                                      .limits = limits,
                                                      .environment = {"LC_ALL=C.UTF-8"},
                                                      .in_child = [&sandbox] { return sandbox.shut(STDERR_FILENO); }});
        finished.timed_out = finished.timed_out || finished.code == 128 + SIGXCPU;
    } else {
        std::error_code ignored;
        fs::create_directories(traces, ignored); // the program says so if it cannot write
        finished = run(program_command(program, part, traces));
    }
    if (finished.code == unknown_part && !part.empty()) throw UserError{last_line(finished.err)};
    if (student) return {true, finished, student_trouble(section, finished, deadline)};
    const std::string left = "the program of " + section.name + " left with exit code ";
    return {true, finished, finished.code == 0 ? "" : left + std::to_string(finished.code)};
}

} // namespace course
