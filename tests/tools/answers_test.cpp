// Mutants and variants: what becomes of a difference to the solution, and that no mistake in one
// stays hidden.

#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <regex>

using Catch::Matchers::ContainsSubstring;
using namespace course;

namespace {

/// A section of two exercises, and answers to them.
struct Answers : SmallCourse {
    Answers() {
        write("chapters/07_wall_meeting/wall_meeting.hpp",
              "COURSE_EXERCISE(\"7.1\", core, wall_meeting, first, \"\", \"\")\n"
              "COURSE_EXERCISE(\"7.2\", core, wall_meeting, second, \"\", \"\")\n");
        write("solutions/07_wall_meeting.cpp", R"(#include <cmath>
namespace wall_meeting {
//> Solution: a helper
int two() { return 2; } // always
//> Solution 7.1: one
int first() {
    int i = 0;
    ++i;

    // again
    ++i;
    return i;
}
//> Solution 7.2: two
int second() { return two(); }
//>
} // namespace wall_meeting
)");
    }
    Finished put_together(const std::string &differences) const {
        write(wrong, differences);
        return run({ANSWERS_IN_ONE, workspace.root.string(), "07_wall_meeting", path("unit.cpp"), path("list"),
                    path("mistakes"), "variants", "mutants"});
    }
    std::string path(const std::string &file) const { return (workspace.root / file).string(); }

    /// The code of one of the answers.
    std::string answer(const std::string &name) const {
        const std::string unit = std::regex_replace(read("unit.cpp"), std::regex{"#line.*\n"}, "");
        const std::string begin = "namespace " + name + " {\nusing namespace wall_meeting;\n";
        const std::size_t from = unit.find(begin);
        REQUIRE(from != std::string::npos);
        return unit.substr(from + begin.size(), unit.find("const Answer", from) - from - begin.size());
    }
    std::string wrong = "tests/07_wall_meeting/mutants.diff";
};

} // namespace

TEST_CASE("a difference replaces lines of its exercise's solution; comments and indentation do not count") {
    const Answers course;
    const Finished done = course.put_together(R"(# what is wrong with them

7.1 starts_at_one: one too many
-int i = 0; // here
+    int i = 1;

7.2 two_is_one: its helper is wrong
-int two() { return 2; }
+int two() { return 1; }

7.1 begins_twice: two changes, and lines that stay to tell one from another
 int i = 0;
-++i;
+i = 1;

+++i;
 return i;

7.1 ends_twice, 8 of 13, yours [0]: a line that has come is not the one that goes
 int i = 0;
+return i;

-return i;
+return 0;
)");
    INFO(done.err);
    REQUIRE(done.code == 0);
    const std::string helper = "int two() { return 2; } // always\n";
    CHECK(course.answer("variant_solution_7_2") == helper + "int second() { return two(); }\n}\n");
    CHECK(course.answer("mutant_starts_at_one")
          == helper + "int first() {\n    int i = 1;\n    ++i;\n\n    // again\n    ++i;\n    return i;\n}\n}\n");
    CHECK(course.answer("mutant_two_is_one") == "int two() { return 1; }\nint second() { return two(); }\n}\n");
    CHECK(course.answer("mutant_begins_twice")
          == helper
                 + "int first() {\n    int i = 0;\n    i = 1;\n\n    // again\n    ++i;\n    ++i;\n    return "
                   "i;\n}\n}\n");
    CHECK(course.answer("mutant_ends_twice")
          == helper
                 + "int first() {\n    int i = 0;\n    return i;\n    ++i;\n\n    // again\n    ++i;\n    return "
                   "0;\n}\n}\n");
    CHECK_THAT(course.read("unit.cpp"),
               ContainsSubstring("#line 5 \"" + course.path(course.wrong) + "\"\n    int i = 1;\n"));
    CHECK(course.read("list")
          == "mutant_begins_twice 7.1 red\n"
             "mutant_ends_twice 7.1 8 of 13, yours [0]\n"
             "mutant_starts_at_one 7.1 red\n"
             "mutant_two_is_one 7.2 red\n"
             "variant_solution_7_1 7.1 all\n"
             "variant_solution_7_2 7.2 all\n");
}

TEST_CASE("a mistake in a difference is an error, which names the place and what to do") {
    const Answers course;
    const auto [text, line, says] = GENERATE(table<std::string, int, std::string>({
        {"7.1 a: b\n-    int j = 0;\n+    int j = 1;\n", 2, "this line must be in"},
        {"7.1 a: b\n-int second() { return two(); }\n", 2, "in what belongs to exercise 7.1: copy from there"},
        {"7.1 a: b\n-    ++i;\n", 2, "must be once in"},
        {"7.1 a: b\n-    ++i;\n", 2, "not 2 times: add a line before or after that stays"},
        {"7.1 a: b\n int i = 0;\n-++i;\n-return i;\n", 2, "these lines, one after the other, must be in"},
        {"7.1 a: b\n+    ++i;\n", 2, "where does this line come?"},
        {"7.1 a: b\n", 1, "changes nothing"},
        {"7.1 a: b\n7.1 c: d\n-return i;\n", 1, "changes nothing"},
        {"-    return i;\n", 1, "neither the head of an answer"},
        {"7.1 a: b\n-    return i;\nreturn 2;\n", 3, "neither the head of an answer"},
        {"7.1 no title\n", 1, "neither the head of an answer"},
        {"7.3 a: b\n-int two() { return 2; }\n", 1, "there is no exercise 7.3 in this section"},
        {"7.1 a: b\n-return i;\n\n7.2 a: b\n-int two() { return 2; }\n", 4, "an answer of this name already"},
    }));
    CAPTURE(text);
    const Finished done = course.put_together(text);
    CHECK(done.code == 1);
    CHECK_THAT(done.err, ContainsSubstring(course.path(course.wrong) + ':' + std::to_string(line) + ": ")
                             && ContainsSubstring(says));
    CHECK_FALSE(course.has("unit.cpp"));
}

TEST_CASE("a whole file is an answer as well, if it says of which exercise") {
    const Answers course;
    course.write("tests/07_wall_meeting/variants/by_hand.cpp", "// 7.2: without help\nint second() { return 2; }\n");
    REQUIRE(course.put_together("").code == 0);
    CHECK_THAT(course.read("unit.cpp"), ContainsSubstring("by_hand.cpp\"\n") && ContainsSubstring("variant_by_hand"));
    CHECK_THAT(course.read("list"), ContainsSubstring("variant_by_hand 7.2 all\n"));
    course.write("tests/07_wall_meeting/variants/by_hand.cpp", "int second() { return 2; }\n");
    const Finished done = course.put_together("");
    CHECK(done.code == 1);
    CHECK_THAT(done.err, ContainsSubstring("by_hand.cpp:1: must begin with its exercise"));
}

TEST_CASE("a wrong answer that passes is found out, a right one that does not, and one that is not there") {
    const SmallCourse course;
    const std::string built = COURSE_BUILD, section = "/07_segment_intersection";
    const auto judge = [&](const std::string &list) {
        course.write("list", list);
        return run({built + "/author" + section, built + "/subjects" + section + "/answers", "--answers",
                    (course.workspace.root / "list").string()});
    };
    const std::string as_expected = "variant_solution_7_1 7.1 all\nvariant_solution_7_1 7.1 19 of 19\n";
    const Finished good = judge(as_expected);
    CHECK(good.code == 0);
    CHECK(good.out == "2 of 2 answers are judged as expected (seed 2026)\n");
    const std::string other =
        GENERATE("variant_solution_7_1 7.1 red", "variant_solution_7_1 7.1 18 of 19",
                 "variant_solution_7_1 7.2 all", // only 7.1 is answered,
                 "variant_solution_7_1 7.2 red", // and what is not started is not wrong
                 "mutant_nobody 7.1 red", "variant_nobody 7.1 all", "variant_solution_7_1 7.9 all");
    const Finished bad = judge(as_expected + other + '\n');
    CHECK(bad.code == 1);
    CHECK_THAT(bad.out, ContainsSubstring("NOT as expected: " + other) && ContainsSubstring("2 of 3 answers"));
    CHECK(judge("").code == 2); // no answer at all is a mistake, too
}

TEST_CASE("the program that checks a student's file knows nothing of what authors ask") {
    const std::string tests = COURSE_BUILD "/tests/07_segment_intersection",
                      answers = COURSE_BUILD "/subjects/07_segment_intersection/answers";
    const std::string mode = GENERATE("--answers", "--kills", "--mistakes", "--all-cases", "--own");
    const Finished done = run({tests, answers, mode, "/dev/null"});
    CHECK(done.code == bad_input);
    CHECK_THAT(done.err, ContainsSubstring("Unrecognised token: " + mode));
    CHECK_THAT(read_file(tests), !ContainsSubstring(mode));
}
