// Runs a command and compares what it prints, and its exit code, with what it printed when somebody last looked at it.
//
//     golden EXPECTED COMMAND...      fails with the first line that differs
//     COURSE_GOLDEN=write golden ...  keeps what it prints now

#include "ground/files.hpp"
#include "ground/process.hpp"

#include <cstdlib>
#include <iostream>
#include <regex>
#include <sstream>

/// Where a check stands in its file may change, and each libstdc++ has its own lines: the verdict is the same.
std::string without_lines(const std::string &text) {
    static const std::regex line{R"((see   tests/\w+\.cpp|\| [\w.]+(?=:\d+: Assertion)):\d+)"};
    return std::regex_replace(text, line, "$1:…");
}

int main(int argc, char **argv) try {
    if (argc < 3) {
        std::cerr << "usage: golden EXPECTED COMMAND...\n";
        return 2;
    }
    const auto result = course::run({argv + 2, argv + argc});
    const std::string now = without_lines(result.out + result.err) + "exit code " + std::to_string(result.code) + '\n';
    if (const char *write = std::getenv("COURSE_GOLDEN"); write != nullptr && std::string_view{write} == "write") {
        course::write_file(argv[1], now);
        return 0;
    }
    const std::string was = course::read_file(argv[1]);
    if (now == was) return 0;

    std::istringstream olds{was}, news{now};
    std::string before, after;
    int line = 1;
    while (std::getline(olds, before) && std::getline(news, after) && before == after) ++line;
    std::cerr << argv[1] << ':' << line << ": expected\n  " << before << "\nbut it says\n  " << after
              << "\nThe whole of it:\n"
              << now;
    return 1;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 2;
}
