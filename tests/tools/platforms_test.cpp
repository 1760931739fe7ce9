// GitHub Classroom and Gradescope: what's exported for them, and a class of twelve through each, as far as it can be run
// without them.

#include "base/lines.hpp"
#include "base/text.hpp"
#include "grade/archive.hpp"
#include "grade/classroom.hpp"
#include "grade/gradescope.hpp"
#include "small_course.hpp"
#include "whole_answer.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

using namespace course;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

const std::string file_of_five = "05_inclined_planes.cpp";

std::string solution_of_five() { return read_file(fs::path{COURSE_ROOT} / "solutions" / file_of_five); }

std::string with(std::string text, const std::string &old, const std::string &instead) {
    REQUIRE(contains(text, old));
    replace_all(text, old, instead);
    return text;
}

/// What twelve hand in, and what that's worth, of 13 points.
struct HandedIn {
    std::string name, text, points;
};
std::vector<HandedIn> twelve() {
    const std::string ours = solution_of_five(), normal = "return mass * g * std::cos(angle);",
                      wrong = with(ours, normal, "return mass * g * std::sin(angle);"),
                      broken = with(ours, normal, "return mass * g * std::cos(angle)"),
                      helper = ours + "\nint helper() { return x; }\n";
    return {{file_of_five, ours, "13"},
            {file_of_five, wrong, ""},
            {file_of_five, broken, ""},
            {file_of_five, read_file(fs::path{COURSE_ROOT} / "tests/05_inclined_planes/stub.cpp"), "0"},
            {file_of_five, "", "0"},
            {file_of_five, "{", "0"},
            {file_of_five, ours + "\nint main() {}\n", "13"},
            {file_of_five, helper, "13"},
            {"mine.cpp", ours, "13"},
            {"work.zip", "PK", "0"},
            {"05_inclined_planes.cpp.txt", ours, "13"},
            {"exercises/" + file_of_five, ours, "13"}};
}

/// Gradescope's machine, with the scripts that are exported, and the course that's built here in the place of its own.
struct Gradescope {
    explicit Gradescope(const std::string &hidden = "") {
        write_file(at / "source/section", "05_inclined_planes\n");
        write_file(at / "source/hidden", hidden);
        for (const char *script : {"setup.sh", "run_autograder"})
            fs::copy(fs::path{COURSE_ROOT} / "tools/grade/gradescope" / script, at / "source");
        write_file(at / "source/course/course",
                   "#!/bin/sh\n[ \"$1\" != setup ] || exit 0\nCOURSE_ROOT='" COURSE_ROOT "' COURSE_BUILD='" COURSE_BUILD
                   "' NO_COLOR=1 exec '" COURSE_TOOL "' \"$@\"\n");
        fs::create_directories(at / "results");
    }
    Finished run_script(const char *script) const {
        return run({"env", "AUTOGRADER=" + at.string(), "sh", (at / "source" / script).string()}, {.deadline = 120});
    }
    void hand_in(const std::string &name, const std::string &text) const {
        fs::remove_all(at / "submission");
        fs::remove(at / "results/results.json");
        write_file(at / "submission" / name, text);
    }
    nlohmann::json results() const { return nlohmann::json::parse(read_file(at / "results/results.json")); }

    OwnFolder folder{"autograder XXXXXX"};
    fs::path at = folder.path;
};

double sum_of(const nlohmann::json &results, const char *what) {
    double sum = 0;
    for (const auto &test : results.at("tests")) sum += test.at(what).get<double>();
    return sum;
}

} // namespace

TEST_CASE("twelve hand in at Gradescope, and each gets a result that it can read") {
    if (sanitized) SKIP("minutes there, and others grade with sanitizers, too");
    const Gradescope gradescope;
    for (const HandedIn &each : twelve()) {
        INFO(each.name << '\n' << each.text);
        gradescope.hand_in(each.name, each.text);
        const Finished done = gradescope.run_script("run_autograder");
        INFO(done.out << done.err);
        REQUIRE(done.code == 0);
        const nlohmann::json results = gradescope.results();
        REQUIRE(results.at("tests").size() == 8);
        CHECK(sum_of(results, "max_score") == 13);
        CHECK(!results.contains("score")); // Gradescope adds up what's earned
        const double sum = sum_of(results, "score");
        if (!each.points.empty()) CHECK(sum == std::stod(each.points));
        else CHECK((sum > 6 && sum < 13));
        for (const auto &test : results.at("tests")) {
            CHECK(test.at("visibility") == "visible");
            CHECK((test.at("status") == "passed") == (test.at("score") == test.at("max_score")));
        }
        CHECK(results.at("output").get<std::string>().find("of 13 points") == std::string::npos); // it's shown there
    }
}

TEST_CASE("what's wrong is told at the exercise it's about, in words of `check`") {
    const Gradescope gradescope;
    gradescope.hand_in(file_of_five, with(solution_of_five(), "return mass * g * std::cos(angle);",
                                          "return mass * g * std::sin(angle);"));
    REQUIRE(gradescope.run_script("run_autograder").code == 0);
    const nlohmann::json results = gradescope.results(), &third = results.at("tests").at(2);
    CHECK(third.at("number") == "5.3");
    CHECK(third.at("name") == "normal_force");
    CHECK(third.at("tags") == nlohmann::json{"core"});
    CHECK_THAT(third.at("output").get<std::string>(), ContainsSubstring("expected"));
    CHECK_THAT(results.at("output").get<std::string>(), ContainsSubstring("Judged: " + file_of_five));
    CHECK(results.at("extra_data").at("tests_sha256").get<std::string>().size() == 64);
}

TEST_CASE("an exercise that's hidden shows no student anything, and the sum isn't told either") {
    const Gradescope gradescope{"5.3\n5.5\n"};
    gradescope.hand_in(file_of_five, solution_of_five());
    REQUIRE(gradescope.run_script("run_autograder").code == 0);
    const nlohmann::json results = gradescope.results();
    for (const auto &test : results.at("tests")) {
        const bool hidden = is_any_of(test.at("number").get<std::string>(), {"5.3", "5.5"});
        CHECK(test.at("visibility") == (hidden ? "hidden" : "visible"));
    }
    const auto output = results.at("output").get<std::string>();
    CHECK_THAT(output, !ContainsSubstring("13") && !ContainsSubstring("5.3") && !ContainsSubstring("normal_force"));
}

TEST_CASE("what calls a hidden exercise doesn't name it, and neither does a compiler") {
    const Gradescope gradescope{"5.3\n"};
    const std::string ours = "return mass * g * std::cos(angle);";
    for (const std::string wrong : {"return mass * g * std::sin(angle);", "throw course::NotYet{\"x\"};",
                                    "return normal_forces(mass * g * std::cos(angle));"}) {
        gradescope.hand_in(file_of_five, with(solution_of_five(), ours, wrong));
        REQUIRE(gradescope.run_script("run_autograder").code == 0);
        const nlohmann::json results = gradescope.results();
        std::string seen = results.at("output");
        for (const auto &test : results.at("tests"))
            if (test.at("visibility") == "visible") seen += test.at("output").get<std::string>();
        INFO(wrong << '\n' << seen);
        CHECK_THAT(seen, !ContainsSubstring("5.3") && !ContainsSubstring("normal_force"));
    }
}

TEST_CASE("a student's own folders, and what a system puts there, are no other students at Gradescope") {
    const Gradescope gradescope;
    gradescope.hand_in("src/" + file_of_five, solution_of_five());
    write_file(gradescope.at / "submission/doc/1003_notes.txt", "x");
    REQUIRE(gradescope.run_script("run_autograder").code == 0);
    CHECK(sum_of(gradescope.results(), "score") == 13);
    gradescope.hand_in(".DS_Store", "x");
    REQUIRE(gradescope.run_script("run_autograder").code == 0);
    CHECK(sum_of(gradescope.results(), "score") == 0);
}

TEST_CASE("who uploads nothing at Gradescope is told so, and gets 0") {
    const Gradescope gradescope;
    fs::create_directories(gradescope.at / "submission");
    REQUIRE(gradescope.run_script("run_autograder").code == 0);
    CHECK(sum_of(gradescope.results(), "score") == 0);
    CHECK_THAT(gradescope.results().at("output").get<std::string>(),
               ContainsSubstring("You handed in an empty upload"));
}

TEST_CASE("a machine on which nothing can be judged gives nobody a 0 at Gradescope, and its image isn't built") {
    const Gradescope gradescope;
    gradescope.hand_in(file_of_five, solution_of_five());
    write_file(gradescope.at / "source/course/course", "#!/bin/sh\n[ \"$1\" != setup ] || exit 0\nexit 3\n");
    CHECK(gradescope.run_script("run_autograder").code == 3);
    CHECK(!fs::exists(gradescope.at / "results/results.json"));
    write_file(gradescope.at / "source/course/solutions" / file_of_five, solution_of_five());
    CHECK(gradescope.run_script("setup.sh").code == 3);
}

TEST_CASE("Gradescope's image is built when our own solution earns all points, and not when it doesn't") {
    const Gradescope gradescope;
    write_file(gradescope.at / "source/course/solutions" / file_of_five, solution_of_five());
    CHECK(gradescope.run_script("setup.sh").code == 0);
    write_file(gradescope.at / "source/course/solutions" / file_of_five,
               with(solution_of_five(), "std::cos(angle);", "std::sin(angle);"));
    const Finished wrong = gradescope.run_script("setup.sh");
    CHECK(wrong.code == 1);
    CHECK_THAT(wrong.err, ContainsSubstring("our own solution has not all points here"));
}

TEST_CASE("one submission has results for Gradescope, a class has none") {
    const OwnFolder folder{"a class XXXXXX"};
    for (const char *id : {"1", "2"}) write_file(folder.path / "in" / id / file_of_five, "");
    const Workspace built{.root = COURSE_ROOT, .build = COURSE_BUILD};
    const Finished both =
        run(course_command(built, {"grade", "5", (folder.path / "in").string(), "--out", (folder.path / "out").string(),
                                   "--gradescope", (folder.path / "results.json").string()}));
    CHECK(both.code == 2);
    CHECK_THAT(both.err, ContainsSubstring("--gradescope writes the results of one submission, and here are 2"));
    CHECK(!fs::exists(folder.path / "results.json"));
}

namespace {

/// A small course in a repository, with the scripts for Gradescope.
struct ExportedCourse : SmallCourse {
    ExportedCourse() {
        write("CMakeLists.txt", "project(x VERSION 1.2.3)\nsection(07_wall_meeting)\n");
        write("tests/points.txt", "core 2\n");
        write("tests/07_wall_meeting/tests.cpp", "// tests\n");
        write(".gitignore", "/build/\n/out/\n");
        for (const std::string script : {"setup.sh", "run_autograder"})
            write("tools/grade/gradescope/" + script, read_file(COURSE_ROOT "/tools/grade/gradescope/" + script));
        git({"init", "--quiet"});
        commit();
    }
    Finished exported(std::vector<std::string> words) const {
        words.insert(words.begin(), "export");
        return (*this)(words);
    }
    std::string out = (workspace.root / "out").string();
};

} // namespace

TEST_CASE("an autograder holds its scripts, the section, and the course with its solutions") {
    const ExportedCourse course;
    course.write("out/mine.txt", "7.1 5\n");
    const Finished made =
        course.exported({"gradescope", "7", course.out, "--hide", "7.2", "--points", course.out + "/mine.txt"});
    INFO(made.err);
    REQUIRE(made.code == 0);
    const Archive zip{fs::path{course.out} / "07_wall_meeting-gradescope.zip"};
    const auto text_of = [&](const std::string &name) {
        const auto entry = std::ranges::find(zip.entries(), name, &Archive::Entry::name);
        return entry == zip.entries().end() ? "none" : zip.read(*entry, 100'000);
    };
    CHECK(text_of("section") == "07_wall_meeting\n");
    CHECK(text_of("hidden") == "7.2\n");
    CHECK(text_of("points.txt") == "7.1 5\n");
    CHECK(text_of("run_autograder") == read_file(COURSE_ROOT "/tools/grade/gradescope/run_autograder"));
    CHECK(text_of("setup.sh") == read_file(COURSE_ROOT "/tools/grade/gradescope/setup.sh"));
    CHECK(text_of("course/solutions/07_wall_meeting.cpp") == course.read("solutions/07_wall_meeting.cpp"));
    CHECK(!fs::exists(fs::path{course.out} / ".export"));

    CHECK_THAT(course.exported({"gradescope", "7", course.out, "--hide", "9.1"}).err, ContainsSubstring("9.1"));
    course.write("out/mine.txt", "7.9 5\n");
    CHECK_THAT(course.exported({"gradescope", "7", course.out, "--points", course.out + "/mine.txt"}).err,
               ContainsSubstring("there's no exercise 7.9"));
}

TEST_CASE("GitHub Classroom's workflow checks each exercise by itself, with what's handed out, for its points") {
    const ExportedCourse course;
    const Finished made = course.exported({"classroom", "7", course.out, "--template", "our-school/section-7"});
    INFO(made.err);
    REQUIRE(made.code == 0);
    const std::string workflow = course.read("out/frame-by-frame/.github/workflows/classroom.yml");
    CHECK_THAT(workflow, ContainsSubstring("          repository: our-school/section-7\n"));
    CHECK_THAT(workflow, ContainsSubstring("&& github.repository != 'our-school/section-7'\n"));
    for (const char *part :
         {"        id: e7-1\n        uses: classroom-resources/autograding-command-grader@v1\n        with:\n"
          "          test-name: 7.1 first\n          command: ./course check 7.1\n          timeout: 10\n"
          "          max-score: 2\n",
          "          test-name: 7.2 second\n          command: ./course check 7.2\n          timeout: 10\n"
          "          max-score: 1\n",
          "          E7-1_RESULTS: ${{ steps.e7-1.outputs.result }}\n"
          "          E7-2_RESULTS: ${{ steps.e7-2.outputs.result }}\n",
          "          runners: e7-1,e7-2\n"})
        CHECK_THAT(workflow, ContainsSubstring(part));
    CHECK_THAT(course.read("out/frame-by-frame/HANDOUT.md"),
               ContainsSubstring("## On GitHub\n") && ContainsSubstring("Write `exercises/07_wall_meeting.cpp`"));
    CHECK(!course.has("out/frame-by-frame/solutions"));

    for (const std::string name : {"section-7", "a/b/c", "https://example.org/a/b", "a/b\n- run: x", ""})
        CHECK(course.exported({"classroom", "7", course.out, "--template", name}).code == 2);
}

TEST_CASE("twelve clones of GitHub Classroom's are graded into its own list") {
    if (sanitized) SKIP("minutes there, and others grade with sanitizers, too");
    const OwnFolder folder{"classroom XXXXXX"};
    const std::vector<HandedIn> all = twelve();
    std::string list = "assignment_name,github_username,roster_identifier,student_repository_name,points_awarded,"
                       "points_available\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string who = "octo" + std::to_string(i + 10), clone = "planes-" + who;
        const std::string name = all[i].name.starts_with("exercises/") ? all[i].name : "exercises/" + all[i].name;
        write_file(folder.path / "clones" / clone / name, all[i].text);
        write_file(folder.path / "clones" / clone / "tests/05_inclined_planes" / file_of_five, "// not this\n");
        list += "planes," + who + ",Student " + std::to_string(i) + ',' + clone + ",3," + (i == 0 ? "99" : "13") + '\n';
    }
    list += "planes,octo99,Student 99,,0,0\n"; // hasn't accepted
    write_file(folder.path / "grades.csv", list);
    const Workspace built{.root = COURSE_ROOT, .build = COURSE_BUILD};
    const Finished done =
        run(course_command(built,
                           {"grade", "5", (folder.path / "clones").string(), "--gradebook",
                            (folder.path / "grades.csv").string(), "--out", (folder.path / "out").string()},
                           {"NO_COLOR=1"}));
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK_THAT(done.out, ContainsSubstring("The gradebook comes from GitHub Classroom: 12 rows; grades go into "
                                           "\"points_awarded\", 13 points at most."));
    const std::string filled = read_file(folder.path / "out/grades.csv"),
                      points = read_file(folder.path / "out/points.csv");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string clone = "planes-octo" + std::to_string(i + 10);
        INFO(clone);
        CHECK_THAT(points, ContainsSubstring(clone + ",Student " + std::to_string(i) + ','));
        if (!all[i].points.empty()) CHECK_THAT(filled, ContainsSubstring(clone + ',' + all[i].points + ','));
        else CHECK_THAT(filled, !ContainsSubstring(clone + ",3,") && !ContainsSubstring(clone + ",13,"));
    }
    CHECK_THAT(filled, ContainsSubstring("octo99,Student 99,,0,0\n"));
}
