#include "ground/files.hpp"
#include "ground/process.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <regex>
#include <set>
#include <sstream>

namespace {

const std::filesystem::path root = COURSE_ROOT;

/// Where a check stands in its file may change: the verdict has not.
std::string without_lines(const std::string &text) {
    return std::regex_replace(text, std::regex{R"((see   tests/\w+\.cpp):\d+)"}, "$1:…");
}

/// What `./course check 1.1` says of a student's file.
std::string verdict_on(const std::string &attempt) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "first attempt.cpp";
    course::write_file(file, attempt);
    const auto said = course::run({"env", "COURSE_ROOT=" COURSE_ROOT, "COURSE_BUILD=" COURSE_BUILD, "NO_COLOR=1",
                                   COURSE_TOOL, "check", "1.1", "--file", file.string()});
    std::filesystem::remove(file);
    return without_lines(said.out);
}

/// So many lines of a text, without the end of the last one.
std::string first_lines(const std::string &text, int count) {
    std::size_t end = 0;
    for (int line = 0; line < count; ++line) end = text.find('\n', end) + 1;
    return text.substr(0, end - 1);
}

/// A verdict as a chapter's box shows it, after its command.
std::string in_box(const std::string &verdict) {
    std::string box = "> $ ./course check 1.1\n";
    std::istringstream lines{verdict};
    for (std::string line; std::getline(lines, line);) box += "> " + line + '\n';
    return box;
}

} // namespace

TEST_CASE("the verdict that the README shows is a real one") {
    std::string verdict = course::read_file(root / "tests/verdicts/wrong_answer.txt");
    verdict.erase(verdict.find("exit code"));
    const std::string readme = without_lines(course::read_file(root / "README.md"));
    CHECK(readme.find("$ ./course check 7\n" + verdict + "```") != std::string::npos);
}

TEST_CASE("the verdicts that chapter 1 shows for 1.1 are real ones, of the lines that it shows") {
    const std::string chapter = without_lines(course::read_file(root / "chapters/01_motion/README.md"));
    const std::string stub = course::read_file(root / "tests/stubs/01_motion.cpp");
    const std::size_t from = stub.find("throw course::NotYet"), to = stub.find(';', from) + 1;
    const auto with = [&](const std::string &line) { return std::string{stub}.replace(from, to - from, line); };
    const auto shows = [&](const std::string &text) {
        INFO(text);
        CHECK(chapter.find(text) != std::string::npos);
    };
    const std::string divides = "return px_per_frame / frames_per_second;";
    const std::string multiplies = "return px_per_frame * frames_per_second;";
    const std::string refuses =
        "course::require(frames_per_second > 0, \"frames_per_second must be positive\", frames_per_second);";

    shows('`' + first_lines(verdict_on(stub), 1) + '`');
    shows('`' + divides + '`');
    shows(in_box(verdict_on(with(divides))) + "> ```");
    shows('`' + multiplies + '`');
    shows(in_box(first_lines(verdict_on(with(multiplies)), 5)) + ">         (and two more)\n> ```");
    shows("    " + refuses + '\n');
    shows('`' + first_lines(verdict_on(with(refuses + '\n' + multiplies)), 1) + '`');
}

TEST_CASE("the numbers of passed tests that a chapter names are those of its wrong answers, and each ✓ has all") {
    const std::string section = GENERATE("11_particles");
    const std::string tests = course::read_file(root / "tests" / (section + ".cpp"));
    const auto tests_of = [&](const std::string &exercise) {
        const std::regex tagged{R"("\[)" + exercise + R"(\]")"};
        return std::to_string(std::distance(std::sregex_iterator{tests.begin(), tests.end(), tagged}, {}));
    };

    std::set<std::string> named, held;
    const std::regex box{R"(Your turn: (\d+\.\d+))"}, count{R"((\d+) of (\d+))"}, red{"> {5}✗ (.+)"},
        green{R"(✓ (\d+\.\d+) \w+, \w+: (\d+) tests passed)"};
    std::istringstream lines{course::read_file(root / "chapters" / section / "README.md")};
    std::string exercise;
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        std::smatch found;
        if (std::regex_search(line, found, box)) exercise = found[1];
        if (std::regex_search(line, found, green)) CHECK(found[2] == tests_of(found[1]));
        if (std::regex_match(line, found, red)) CHECK(tests.find('"' + found[1].str() + '"') != std::string::npos);
        for (std::sregex_iterator at{line.begin(), line.end(), count}, end; at != end; ++at)
            if (at->str(2) == tests_of(exercise)) named.insert(exercise + ", " + at->str());
    }

    const std::string wrong = course::read_file(root / "tests/wrong" / (section + ".diff"));
    const std::regex head{R"(\n(\d+\.\d+) \w+, (\d+ of \d+): )"};
    for (std::sregex_iterator at{wrong.begin(), wrong.end(), head}, end; at != end; ++at)
        held.insert(at->str(1) + ", " + at->str(2));
    CHECK(named == held);
}
