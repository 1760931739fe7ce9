#include "loop/programs.hpp"

#include "ground/complaint.hpp"
#include "ground/hidden.hpp"
#include "ground/lines.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"
#include "loop/diagnosis.hpp"

#include <array>
#include <cmath>
#include <csignal>
#include <sstream>

namespace course {
namespace fs = std::filesystem;

fs::path reference_traces(const Tree &tree, const Section &section) { return tree.build / "traces" / section.name; }

fs::path student_traces(const Tree &tree, const Section &section) {
    return tree.build / "mine" / "traces" / section.name;
}

Finished build_target(const Tree &tree, const std::string &target) {
    Finished built = run({"cmake", "--build", tree.build.string(), "--target", target});
    built.out = plain_output(built.out);
    built.err = plain_output(built.err);
    return built;
}

fs::path program_binary(const Tree &tree, const Section &section, Whose whose) {
    return tree.build / (whose == Whose::student ? "mine" : "chapters") / section.name;
}

std::string said_of(const Finished &finished, const std::string &trace) {
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

std::string first_error(const std::string &printed) {
    const auto lines = lines_of(printed);
    const std::string_view undefined = "undefined reference to ";
    for (const auto &[line, end] : lines)
        if (const std::size_t at = line.find(undefined); at != line.npos && line.ends_with('\'')) {
            const std::string_view quoted = line.substr(at + undefined.size()); // `name' or 'name'
            return std::string{quoted.substr(1, quoted.size() - 2)}
                   + " is not defined; has its name or its signature changed?";
        }
    for (const char *mark : {"multiple definition of", "error: "})
        for (const auto &[line, end] : lines)
            if (contains(line, mark)) return std::string{line};
    for (const auto &[line, end] : lines) // a compiler that speaks another language: file.cpp:12:5: …
        if (const std::size_t colon = line.find(':'); colon < line.find(' ') && leading_number(line.substr(colon + 1)))
            return std::string{line};
    return "";
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

std::string student_error(const Tree &tree, const Section &section, const std::string &printed) {
    const fs::path file = tree.exercise(section);
    const std::string name = tree.shown(file);
    Verdict verdict = diagnose_compiler(printed, file, name, renamed(tree, section));
    if (verdict.line == 0) verdict = diagnose_linker(printed, name, section.short_number());
    return (verdict.line == 0 ? "" : verdict.file + ':' + std::to_string(verdict.line) + ": ") + verdict.sentence;
}

namespace {

/// How a student's program ended, if not well. A part that could not run has said so itself: chapters/program.hpp.
std::string student_trouble(const Section &section, const Finished &finished, double deadline) {
    const std::string check = "`./course check " + section.short_number() + "`";
    if (finished.timed_out)
        return "your program was stopped after " + std::to_string(std::lround(deadline)) + " s, it would not end; "
               + check + " says which function it is in";
    if (finished.code > 128)
        return "your program " + meaning_of_signal(finished.code - 128) + "; " + check + " says in which function";
    if (finished.code == 0) return "";
    if (finished.code == 1 && contains(finished.err, "error: "))
        return "some parts of the program failed, because one of your functions threw, perhaps at what another one had "
               "answered; "
               + check + " shows what is wrong";
    if (is_only_unfinished(finished))
        return "some parts of the program need functions that are not started; " + check + " shows which";
    const std::string said = last_line(finished.err);
    return "your program stopped with exit code " + std::to_string(finished.code)
           + (said.empty() ? " and printed no error" : ", and the last line it printed was \"" + said + "\"") + "; "
           + check + " shows what is wrong";
}

/// An empty folder, so that no trace of an earlier run is taken for one of this run.
void empty_folder(const fs::path &folder) {
    std::error_code trouble;
    fs::remove_all(folder, trouble);
    fs::create_directories(folder, trouble);
    if (trouble)
        throw Complaint{"cannot write " + folder.string() + ": " + trouble.message()
                        + "; make the build folder writable, or run this as its owner."};
}

/// Starts what follows with limits, so that a runaway function cannot bring the machine down: no core file, files
/// of 100 MB, 4 GB of memory.
constexpr const char *limited = sanitized ? "ulimit -c 0; ulimit -f 200000; exec \"$@\""
                                          : "ulimit -c 0; ulimit -f 200000; ulimit -v 4000000 2>/dev/null; exec \"$@\"";

Ran run_student(const Tree &tree, const Section &section, const fs::path &traces, const std::string &part,
                double deadline) {
    tree.written_exercise(section);
    if (const Finished built = build_target(tree, section.name + "_mine"); built.code != 0)
        return {
            false, {}, "your program cannot be built: " + student_error(tree, section, built.out + '\n' + built.err)};
    empty_folder(traces);
    std::vector<std::string> command = program_command(program_binary(tree, section, Whose::student), part, traces);
    command.insert(command.begin(), {"sh", "-c", limited, "sh"});
    const Finished finished = run(command, {.quiet = true, .deadline = deadline, .folder = traces});
    if (finished.code == unknown_part && !part.empty()) throw Complaint{last_line(finished.err)};
    return {true, finished, student_trouble(section, finished, deadline)};
}

Ran run_reference(const Tree &tree, const Section &section, const fs::path &traces, const std::string &part) {
    if (const Finished built = build_target(tree, section.name); built.code != 0)
        return {false,
                {},
                "the program of " + section.name + " cannot be built: " + first_error(built.out + '\n' + built.err)};
    std::error_code ignored;
    fs::create_directories(traces, ignored); // the program says so if it cannot write
    const Finished finished = run(program_command(program_binary(tree, section, Whose::reference), part, traces));
    if (finished.code == unknown_part && !part.empty()) throw Complaint{last_line(finished.err)};
    if (finished.code == 0) return {true, finished, ""};
    return {true, finished, "the program of " + section.name + " left with exit code " + std::to_string(finished.code)};
}

} // namespace

Ran run_program(const Tree &tree, const Section &section, Whose whose, const fs::path &traces, const std::string &part,
                double deadline) {
    const fs::path folder = fs::absolute(traces);
    return whose == Whose::student ? run_student(tree, section, folder, part, deadline)
                                   : run_reference(tree, section, folder, part);
}

} // namespace course
