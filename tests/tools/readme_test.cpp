#include "small_course.hpp"
#include "whole_answer.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace {

const std::filesystem::path root = COURSE_ROOT;

/// The folders of all chapters: 01_motion and so on.
std::vector<std::string> all_chapters() {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator{root / "chapters"})
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

/// What `./course check` says of a student's file: of an exercise or a section.
std::string verdict_on(const std::string &attempt, const std::string &what = "1.1") {
    const course::OwnFolder folder;
    const std::filesystem::path file = folder.path / "first attempt.cpp";
    course::write_file(file, attempt);
    return without_lines(
        course::run(course::course_command({root, COURSE_BUILD}, {"check", what, "--file", file.string()})).out);
}

/// The stub of section 1 with code in the place of the `throw` of each of these exercises.
std::string stub_with(const std::map<std::string, std::string> &answers) {
    std::string text = course::read_file(root / "tests/01_motion/stub.cpp");
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
    shows("> ```cpp\n>     " + refuses + "\n>     " + multiplies + "\n> ```");
    shows('`' + first_line(verdict_on(stub_with({{"1.1", refuses + multiplies}}))) + '`');
}

TEST_CASE("the verdict that chapter 1 shows for the first try of 1.3 is a real one, and its lines for 1.4 are right") {
    const std::string chapter = course::read_file(root / "chapters/01_motion/README.md");
    const std::vector<std::string> lines{"double total = 0;", "Vec2 sum = {0, 0};",
                                         "for (const PointMass &body : bodies) { total += body.mass; }",
                                         "if (total == 0) return {};", "return sum / 2;"};
    std::vector<std::string> rows;
    for (const std::string &line : lines) rows.push_back("> | `" + line + "` |");
    CHECK(is_in_order(rows, chapter));
    const std::string verdict = verdict_on(stub_with({{"1.3", R"(
    const Vec2 last = start.velocity + t * acceleration;
    return {start.position + t * last, last};)"},
                                                      {"1.4", lines[0] + lines[1] + R"(
    for (const PointMass &body : bodies) {
        total += body.mass;
        sum += body.mass * body.position;
    })" + lines[3] + R"(
    return sum / total;)"}}),
                                           "1");
    CHECK(is_in_order(lines_in_box(chapter, "1.3"), verdict));
    const std::string green = "✓ 1.4 centre_of_mass, core: 11 tests passed";
    CHECK(is_in_order({green}, verdict));
    CHECK(is_in_order({'`' + green + '`'}, chapter));
}

TEST_CASE(
    "the counts of tests, and each `yours`, that a chapter names are those of its wrong answers; each ✓ has all") {
    const std::string section = GENERATE(from_range(all_chapters()));
    const std::string tests = course::read_file(root / "tests" / section / "tests.cpp");
    const auto tests_of = [&](const std::string &exercise) {
        const std::regex tagged{R"("\[)" + exercise + R"(\]")"};
        return std::to_string(std::distance(std::sregex_iterator{tests.begin(), tests.end(), tagged}, {}));
    };

    std::set<std::string> named, held;
    const std::regex box{R"(Your turn: (\d+\.\d+))"}, count{R"((\d+) of (\d+))"},
        red{"> {5}✗ (.+?)(?:  not a number)?"}, green{R"(✓ (\d+\.\d+) \w+, \w+: (\d+) tests passed)"},
        code{"`([^`]*)`"};
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
        const bool in_list =
            line.starts_with("> - `") || line.starts_with("- `"); // below "If another `yours` stands …:"
        if (!in_list && line.find("`yours`") == line.npos && line.find("`returned`") == line.npos) continue;
        for (std::sregex_iterator at{line.begin(), line.end(), code}, end; at != end; ++at)
            if (at->str(1).find_first_of("0123456789") != line.npos) named.insert(exercise + ", yours " + at->str(1));
    }

    const std::string wrong = course::read_file(root / "tests" / section / "mutants.diff");
    const std::regex head{R"(\n(\d+\.\d+) \w+(?:, (\d+ of \d+))?(?:, (yours [^:\n]+))?: )"};
    for (std::sregex_iterator at{wrong.begin(), wrong.end(), head}, end; at != end; ++at)
        for (const std::size_t part : {2u, 3u})
            if ((*at)[part].matched) held.insert(at->str(1) + ", " + at->str(part));
    CHECK(named == held);
}

TEST_CASE("what the page on trust says of a section's peers in one number is no less than any difference that's kept") {
    static const std::regex row{R"(\n\| (\d+) \|[^\n]*\| ([\d.e-]+)(?:, [^;|\n]*)? \|(?=\n(?!\| \|)))"};
    const std::string page = course::read_file(root / "docs/trust.md");
    int said = 0;
    for (std::sregex_iterator found{page.begin(), page.end(), row}, end; found != end; ++found) {
        const std::string number = found->str(1);
        const std::string start = (number.size() == 1 ? "0" : "") + number + '_';
        const std::vector<std::string> chapters = all_chapters();
        const auto section = std::ranges::find_if(chapters, [&](const auto &name) { return name.starts_with(start); });
        REQUIRE(section != chapters.end());
        ++said;
        INFO(*section);
        std::istringstream kept{course::read_file(root / "tests" / *section / "peer.txt")};
        std::string line;
        std::getline(kept, line); // its title
        while (std::getline(kept, line)) CHECK(std::stod(line) < std::stod(found->str(2)));
    }
    CHECK(said == 4); // of 3, 4, 9 and 10; the others say more than one number
}

TEST_CASE("the numbers that the page on trust gives of section 7 are those that its comparison found") {
    static const std::regex row{R"(\n\| 7 \|[^\n]*)"}, number{R"([\d.]+e-\d+)"};
    const std::string page = course::read_file(root / "docs/trust.md");
    const std::string kept = course::read_file(root / "tests/07_segment_intersection/peer.txt");
    std::smatch found;
    REQUIRE(std::regex_search(page, found, row));
    const std::string said = found.str();
    int numbers = 0;
    for (std::sregex_iterator each{said.begin(), said.end(), number}, end; each != end; ++each, ++numbers)
        CHECK_THAT(kept, ContainsSubstring('\n' + each->str() + ' '));
    CHECK(numbers == 3);
}

TEST_CASE("a beginner wins most matches against the easy machine of table hockey, and some against the hard one") {
    const std::string chapter = course::read_file(root / "chapters/13_table_hockey/README.md"); // woven: the program's
    const auto won = [&](const std::string &level) {
        std::smatch found;
        REQUIRE(std::regex_search(chapter, found, std::regex{"\n" + level + " +(\\d+) +\\d+ +\\d+\n"}));
        return std::stoi(found[1]);
    };
    CHECK((won("easy") >= 60 && won("easy") <= 90));
    CHECK((won("hard") >= 10 && won("hard") <= 40));
}
