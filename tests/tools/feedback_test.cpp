// `course feedback`: what it remembers of checks, and the text that it makes of that.

#include "check/feedback.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace course;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("a line tells of an exercise: checks, how it stands, hints, and the minutes between the checks") {
    const std::string text = feedback({{"7.10", "wrong", "you add.", "2026-11-29T10:00:00Z"},
                                       {"7.10", "does not compile", "", "2026-11-29T10:03:10Z"},
                                       {"7.10", "wrong", "you add.", "2026-11-29T12:00:00Z"},
                                       {"7.10", "passed", "", "2026-11-29T12:00:20Z"},
                                       {"7.9", "wrong", "", "2026-11-29T23:59:00Z"},
                                       {"13.1", "passed", "", "no time"},
                                       {"13.1", "passed", "", "2026-11-29T12:00:20Z"}},
                                      {{"7.10", 2}}, "Frame by Frame 1.2.3");
    CHECK(text == R"(Frame by Frame 1.2.3: how it went, with no code, no name, and nothing of the machine.

exercise  checks  now              hints  minutes between the checks
7.9            1  wrong                0  -
7.10           4  passed               2  3 break 0
    2 times: you add.
13.1           2  passed               0  ?
)");
}

TEST_CASE("attempts are kept in their order, by exercise, and a broken file counts as none") {
    const SmallCourse course;
    remember_attempts(course.workspace, {{"7.1", "wrong", "you add."}, {"7.2", "passed"}});
    remember_attempts(course.workspace, {{"7.1", "passed"}});
    const std::vector<Attempt> all = recall_attempts(course.workspace);
    REQUIRE(all.size() == 3);
    CHECK(all[0].mistake == "you add.");
    CHECK(all[1].number == "7.1");
    CHECK(all[1].state == "passed");
    CHECK(all[1].when >= all[0].when);
    CHECK(all[2].number == "7.2");
    course.write(".course/attempts.json", R"({"7.1": 5, "7.2": [3, {"state": 7}]})");
    CHECK(recall_attempts(course.workspace).size() == 1);
}

TEST_CASE("feedback writes a file with what it shows, or says that check comes first") {
    const SmallCourse course;
    const std::string file = (course.workspace.root / "told.txt").string();
    const Finished nothing = course({"feedback", "--out", file});
    CHECK(nothing.code == 2);
    CHECK_THAT(nothing.err, ContainsSubstring("./course check comes first"));
    CHECK_FALSE(course.has("told.txt"));

    remember_attempts(course.workspace, {{"7.1", "wrong", "you add."}});
    remember_rungs(course.workspace, "7.1", 1);
    const Finished told = course({"feedback", "--out", file});
    CHECK(told.code == 0);
    CHECK_THAT(course.read("told.txt"),
               ContainsSubstring("7.1            1  wrong                1  -\n    once: you add.\n"));
    CHECK_THAT(told.out, ContainsSubstring(course.read("told.txt")));
}
