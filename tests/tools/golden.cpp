// Runs a command and compares what it prints, and its exit code, with what it printed when somebody last looked at it.
//
//     golden EXPECTED.txt COMMAND... FILE.cpp   fails with the first line that differs
//     COURSE_GOLDEN=write golden ...            keeps what it prints now
//
// Where FILE.cpp includes rest.hpp, what is checked is the whole answer: see whole_answer.hpp.

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "judge/runner/sandbox.hpp"
#include "whole_answer.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace fs = std::filesystem;

constexpr int skipped = 77; // see SKIP_RETURN_CODE

/// Everything that a student's file may not change: files of the course with size and date, and shared memory.
std::string state(const fs::path &root, const fs::path &build) {
    std::ostringstream all;
    const auto add = [&](const fs::directory_entry &entry) {
        if (entry.is_regular_file())
            all << entry.path().string() << ' ' << entry.file_size() << ' '
                << entry.last_write_time().time_since_epoch().count() << ' '
                << static_cast<int>(entry.status().permissions()) << '\n';
    };
    for (const char *folder : {"chapters", "exercises", "solutions", "tests"})
        for (const auto &entry : fs::recursive_directory_iterator{root / folder}) add(entry);
    for (const char *folder : {"tests", "catalogue"})
        for (const auto &entry : fs::directory_iterator{build / folder}) add(entry);
    std::ifstream segments{"/proc/sysvipc/shm"};
    all << segments.rdbuf();
    for (const char *file : {"/dev/shm/left-by-an-exercise", "/tmp/written-by-an-exercise"})
        all << file << (fs::exists(file) ? " is there\n" : " is not there\n");
    return all.str();
}

/// What the command has left running: orphans come to us.
std::string left_running() {
    std::string processes;
    std::getline(std::ifstream{"/proc/self/task/" + std::to_string(::getpid()) + "/children"}, processes);
    return processes;
}

/// The first line that differs; empty if none does.
std::string difference(const std::string &was, const std::string &now) {
    if (was == now) return "";
    std::istringstream olds{was}, news{now};
    std::string before, after;
    int line = 1;
    do {
        before = after = "(nothing)";
    } while (std::getline(olds, before) && std::getline(news, after) && before == after && line++ > 0);
    return std::to_string(line) + ": expected\n  " + before + "\nbut it says\n  " + after + '\n';
}

int main(int argc, char **argv) try {
    if (argc < 3) {
        std::cerr << "usage: golden EXPECTED COMMAND...\n";
        return 2;
    }
    std::vector<std::string> command{argv + 2, argv + argc};
    const fs::path given = command.back(), root = std::getenv("COURSE_ROOT"), build = std::getenv("COURSE_BUILD");
    const fs::path checked = build / "verdicts" / given.filename();
    const auto protection = course::protection_of_this_kernel();
    if (given.parent_path().filename() == "hostile" && !(protection.files && protection.calls)) {
        std::cerr << "skipped: this kernel lacks Landlock or seccomp, and the verdict on this file needs both\n";
        return skipped;
    }
    course::write_file(checked, whole_answer(given, "tests/verdicts/rest.hpp"));
    command.back() = checked.string();
#ifdef __linux__
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    const std::string before = state(root, build);
    const auto result = course::run(command);
    const std::string left = left_running(), changed = difference(before, state(root, build));
    std::string said = result.out + result.err;
    course::replace_all(said, checked.string(), given.string());
    course::replace_all(said, checked.lexically_relative(root).string(),
                        given.string()); // as it is called in the checkout
    const std::string now = without_lines(said) + "exit code " + std::to_string(result.code) + '\n';
    if (const char *write = std::getenv("COURSE_GOLDEN"); write != nullptr && std::string_view{write} == "write") {
        course::write_file(argv[1], now);
        return 0;
    }
    const std::string wrong = difference(course::read_file(argv[1]), now);
    if (!wrong.empty()) std::cerr << argv[1] << ':' << wrong << "The whole of it:\n" << now;
    if (!left.empty()) std::cerr << "processes were left running: " << left << '\n';
    if (!changed.empty()) std::cerr << "files have changed; line " << changed;
    return wrong.empty() && left.empty() && changed.empty() ? 0 : 1;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 2;
}
