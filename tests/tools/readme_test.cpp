#include "ground/files.hpp"
#include "ground/process.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace {

const std::filesystem::path root = COURSE_ROOT;

/// Where a check stands in its file may change: the verdict has not.
std::string without_lines(const std::string &text) {
    return std::regex_replace(text, std::regex{R"((see   tests/\w+\.cpp):\d+)"}, "$1:…");
}

/// What `./course check` says of a student's file: of an exercise or a section.
std::string verdict_on(const std::string &attempt, const std::string &what = "1.1") {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "first attempt.cpp";
    course::write_file(file, attempt);
    const auto said = course::run({"env", "COURSE_ROOT=" COURSE_ROOT, "COURSE_BUILD=" COURSE_BUILD, "NO_COLOR=1",
                                   COURSE_TOOL, "check", what, "--file", file.string()});
    std::filesystem::remove(file);
    return without_lines(said.out);
}

/// The stub of section 1 with code in the place of the `throw` of each of these exercises.
std::string stub_with(const std::map<std::string, std::string> &answers) {
    std::string text = course::read_file(root / "tests/stubs/01_motion.cpp");
    for (const auto &[number, code] : answers) {
        const std::size_t from = text.find("throw course::NotYet", text.find("// " + number + ' '));
        text.replace(from, text.find("};", from) + 2 - from, code);
    }
    return text;
}

std::string first_line(const std::string &text) { return text.substr(0, text.find('\n')); }

/// Whether a text has all of these, one after the other.
bool is_in_order(const std::vector<std::string> &pieces, const std::string &text) {
    std::size_t at = 0;
    for (const std::string &piece : pieces) {
        at = text.find(piece, at);
        if (at == text.npos) return false;
        at += piece.size();
    }
    return !pieces.empty();
}

/// A verdict as a chapter's box shows it, after its command.
std::string in_box(const std::string &verdict) {
    std::string box = "> $ ./course check 1.1\n";
    std::istringstream lines{verdict};
    for (std::string line; std::getline(lines, line);) box += "> " + line + '\n';
    return box;
}

/// The lines of a verdict in a chapter's box, without those that are left out there.
std::vector<std::string> lines_in_box(const std::string &chapter, const std::string &exercise) {
    const std::string command = "> $ ./course check " + exercise + '\n';
    const std::size_t from = chapter.rfind(command) + command.size();
    std::istringstream box{chapter.substr(from, chapter.find("> ```", from) - from)};
    std::vector<std::string> lines;
    for (std::string line; std::getline(box, line);)
        if (!line.ends_with("…")) lines.push_back(line.substr(2) + '\n');
    return lines;
}

/// "4 of 12", the passed tests of an exercise.
std::string count_in(const std::string &verdict, const std::string &exercise) {
    const std::regex line{"✗ " + exercise + R"( \w+, \w+: (\d+ of \d+) tests passed)"};
    std::smatch found;
    return std::regex_search(verdict, found, line) ? found[1].str() : "no count of " + exercise;
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
    const auto shows = [&](const std::string &text) {
        INFO(text);
        CHECK(chapter.find(text) != std::string::npos);
    };
    const std::string divides = "return px_per_frame / frames_per_second;";
    const std::string multiplies = "return px_per_frame * frames_per_second;";
    const std::string refuses =
        "course::require(frames_per_second > 0, \"frames_per_second must be positive\", frames_per_second);";

    shows('`' + first_line(verdict_on(stub_with({}))) + '`');
    shows('`' + divides + '`');
    shows(in_box(verdict_on(stub_with({{"1.1", divides}}))) + "> ```");
    shows('`' + multiplies + '`');
    CHECK(is_in_order(lines_in_box(chapter, "1.1"), verdict_on(stub_with({{"1.1", multiplies}}))));
    shows("    " + refuses + '\n');
}

TEST_CASE("the verdicts and counts that chapter 1 gives for 1.2 to 1.4 are those of the attempts that it describes") {
    const std::string chapter = course::read_file(root / "chapters/01_motion/README.md");
    const std::string last = "const Vec2 last = start.velocity + t * acceleration; ";
    const auto sums = [](const std::string &loop) {
        return "double total = 0; Vec2 sum = {0, 0}; for (const PointMass &body : bodies) { " + loop + " } ";
    };
    const std::string weighted = sums("total += body.mass; sum += body.mass * body.position;");
    const auto shows = [&](const std::string &text) {
        INFO(text);
        CHECK(chapter.find(text) != std::string::npos);
    };

    const std::string first = verdict_on(stub_with({{"1.2", "return t * velocity;"},
                                                    {"1.3", last + "return {start.position + t * last, last};"},
                                                    {"1.4", weighted + "return sum / total;"}}),
                                         "1");
    shows("1.2, a hint: only " + count_in(first, "1.2") + ", and it is 200 too small");
    CHECK(first.find("got   (120, 0) m") != std::string::npos);
    CHECK(is_in_order(lines_in_box(chapter, "1.3"), first));
    CHECK(is_in_order(lines_in_box(chapter, "1.4"), first));

    const std::string without_masses = sums("total += 1; sum += body.position;") + "return sum / total;";
    const std::string second = verdict_on(
        stub_with({{"1.3", last + "return {uniform_motion(start.position, (start.velocity + last) / 2, t), last};"},
                   {"1.2", "return start + t * velocity;"},
                   {"1.4", without_masses}}),
        "1");
    shows("1.3, a hint: " + count_in(second, "1.3") + ", and the test of the limits is red");
    shows(count_in(second, "1.4") + "? Then you have forgotten the masses");

    const std::string third =
        verdict_on(stub_with({{"1.3", last + "return {start.position + t * start.velocity, last};"},
                              {"1.4", sums("total += 1; sum += body.mass * body.position;") + "return sum / total;"}}),
                   "1");
    shows("(Is yours at 54 m?");
    CHECK(third.find("got   position = (54, 0) m") != std::string::npos);
    shows(count_in(third, "1.4") + "? Then only one of the two sums has its masses");

    const std::string nothing = verdict_on(stub_with({{"1.4", "return {};"}}), "1");
    shows("1.4, a hint: only " + count_in(nothing, "1.4") + ", and the answer is always nothing");
}

TEST_CASE("chapter 1 says of each exercise how many tests it passes in the end") {
    const std::string chapter = course::read_file(root / "chapters/01_motion/README.md");
    std::istringstream lines{verdict_on(course::read_file(root / "solutions/01_motion.cpp"), "1")};
    int passed = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("✓ 1.")) continue;
        INFO(line);
        CHECK(chapter.find('`' + line + '`') != std::string::npos);
        ++passed;
    }
    CHECK(passed == 7);
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
