// `course mytests`: the file that a reader gets, and what is made of tests that are right, too strict, or none at all.

#include "base/kernel.hpp"
#include "base/text.hpp"
#include "check/own_tests.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <utility>

using Catch::Matchers::ContainsSubstring;
using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char *tests_of_mine = "exercises/07_wall_meeting_tests.cpp";

/// A small course with answers, right and wrong; none of it is built.
struct WithAnswers : SmallCourse {
    WithAnswers() { write("tests/07_wall_meeting/mutants.diff", "7.1 one: you return one\n"); }
};

/// The course's own section 7, with its build, and with tests of a reader's in a checkout of their own.
struct SectionSeven {
    SectionSeven() {
        workspace = {.root = folder.path, .build = COURSE_BUILD};
        write_file(workspace.root / "CMakeLists.txt", "section(07_segment_intersection)\n");
        for (const char *name : {"solutions/07_segment_intersection.cpp", "tests/07_segment_intersection/mutants.diff"})
            write_file(workspace.root / name, "");
    }
    Finished operator()(const std::string &tests) const {
        if (sanitized) SKIP("with sanitizers there are no wrong answers");
        write_file(workspace.own_tests(workspace.section("7")),
                   "#include \"own_test.hpp\"\n\n#include \"segment_intersection.hpp\"\n"
                   "namespace segment_intersection::subject {\n"
                       + tests + "\n}\n");
        return run(course_command(workspace, {"mytests", "7"}), {.deadline = 300});
    }
    OwnFolder folder{"my tests XXXXXX"};
    Workspace workspace;
};

} // namespace

TEST_CASE("mytests makes a file with one empty test, says what to write first, and never writes over it") {
    const WithAnswers course;
    const Finished first = course({"mytests", "7"}), second = course({"mytests", "7"});
    CHECK(first.code == 0);
    CHECK_THAT(first.out, ContainsSubstring(tests_of_mine) && ContainsSubstring("call `first` there"));
    CHECK_THAT(course.read(tests_of_mine), ContainsSubstring("\nnamespace wall_meeting::subject {\n\nTEST_CASE(")
                                               && ContainsSubstring("#include \"wall_meeting.hpp\""));
    CHECK(second.code == 1);
    CHECK_THAT(second.out, ContainsSubstring("still has its one empty test"));

    course.write(tests_of_mine, "// mine");
    CHECK(course({"mytests", "7"}).code != 0); // this course isn't built
    CHECK(course.read(tests_of_mine) == "// mine");
}

TEST_CASE("mytests says so, and makes nothing, where the course has no answers") {
    const SmallCourse course;
    const Finished said = course({"mytests", "7"});
    CHECK(said.code == 2);
    CHECK_THAT(said.err, ContainsSubstring("has no answers to section 7"));
    CHECK_FALSE(course.has(tests_of_mine));
    CHECK_THAT(WithAnswers{}({"mytests", "7.1"}).err, ContainsSubstring("./course mytests 7\n"));
}

TEST_CASE("reset --tests brings the empty test back, and keeps a copy of the reader's") {
    const WithAnswers course;
    course.write(tests_of_mine, "// mine");
    CHECK(course({"reset", "7", "--tests"}).code == 2); // without a terminal it can't ask
    CHECK(course({"reset", "7", "--tests", "--yes"}).code == 0);
    REQUIRE(course.kept().size() == 1);
    CHECK(read_file(course.kept()[0]) == "// mine");
    CHECK_THAT(course.read(tests_of_mine), ContainsSubstring("TEST_CASE("));
    CHECK_THAT(course.read(course.workspace.exercise(course.seven())), ContainsSubstring("nothing done yet"));
}

TEST_CASE("tests that are right are told which mistakes they catch, in the exercises that they call") {
    const Finished said = SectionSeven{}(R"(
TEST_CASE("two walls that cross") {
    CHECK(segments_intersect({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}));
    const auto both = intersect_lines({{0, 0}, {4, 4}}, {{0, 2}, {2, 0}});
    CHECK_THAT(both.value().point, IsNear(Vec2{1, 1}, 1e-9));
    CHECK(both->t == Approx(0.25));
})");
    INFO(said.out << said.err);
    CHECK(said.code == 0);
    CHECK_THAT(said.out,
               ContainsSubstring("✓ 7.1 intersect_lines, core: accepts all ")
                   && ContainsSubstring("✓ 7.2 segments_intersect, core: accepts all ")
                   && ContainsSubstring(
                       "    ✓ when you add the two products of the determinant\n    ✓ when you follow the motion by s")
                   && ContainsSubstring(" get past your tests."));
    CHECK(said.out.find("7.3") == std::string::npos);
}

TEST_CASE("a test that fails a right answer is shown with its call, and asked about no mistakes") {
    const Finished said = SectionSeven{}(R"(
TEST_CASE("wrong") { CHECK_THAT(segments_intersect({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}), IsNear(false)); }
TEST_CASE("too exact") {
    CHECK_THAT(intersect_lines({{4, 7}, {16, 3}}, {{1, 1}, {17, 10}}).value().t, IsNear(69.0 / 172));
}
TEST_CASE("no test") { CHECK(1 + 1 == 2); }
TEST_CASE("no check") { orientation({{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}); }
)");
    INFO(said.out << said.err);
    CHECK(said.code == 1);
    CHECK_THAT(
        said.out,
        ContainsSubstring("✗ wrong: our solution fails it\n    Your test wants false, but a right answer has true.")
            && ContainsSubstring("call      segments_intersect() with")
            && ContainsSubstring("see       exercises/07_segment_intersection_tests.cpp:6\n")
            && ContainsSubstring("✗ 7.2 segments_intersect, core: no test of yours accepts")
            && ContainsSubstring("✗ too exact: our solution passes, but another right answer doesn't (")
            && ContainsSubstring("allow for that, with IsNear(…, 1e-9)")
            && ContainsSubstring("This test calls none of the section's functions")
            && ContainsSubstring("✗ no check: it has nothing to say\n    This test checks nothing"));
}

TEST_CASE("a test that never ends, crashes or leaves costs no other test its turn") {
    const Finished said = SectionSeven{}(R"(
TEST_CASE("endless") { for (volatile bool more = true; more;) {} }
TEST_CASE("beyond") { std::vector<int> none; CHECK(none[1] == 1); }
TEST_CASE("leaves") { std::exit(0); }
TEST_CASE("prints") { std::puts("here I am"); CHECK(orientation({{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}) == 2); }
TEST_CASE("loops on mistakes") { for (int sign = 0; sign != 1;) sign = orientation({{0, 0}, {1, 0}}, {{0, 0}, {0, 1}});
    SUCCEED(); }
)");
    INFO(said.out << said.err);
    CHECK(said.code == 1);
    CHECK_THAT(said.out,
               ContainsSubstring("✗ endless: it goes wrong by itself\n    Your test doesn't come to an end")
                   && ContainsSubstring("stopped by a check of the library: an index beyond the end")
                   && ContainsSubstring("✗ leaves: it goes wrong by itself\n    Your test ended the program")
                   && ContainsSubstring("orientation({{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}) == 2, that is 1 == 2")
                   && ContainsSubstring("| here I am")
                   && ContainsSubstring("✗ 7.6 orientation, challenge: without what's red above, catches "));
    CHECK(said.out.find("catches 0 ") == std::string::npos);
}

TEST_CASE("tests that can't be compiled or linked are told why, as an exercise is") {
    const auto [tests, why] = GENERATE(table<std::string, std::string>(
        {{"TEST_CASE(\"a\") { CHECK(orientaton({}, {}) == 1); }", "_tests.cpp:5: 'orientaton' was not declared"},
         {"TEST_CASE(\"a\") { CHECK(intersect_lines({}, {}).value() == LineIntersection{}); }",
          "CHECK_THAT(…, IsNear(Name{…}"},
         {"} TEST_CASE(\"a\") { CHECK(segment_intersection::orientation({}, {}) == 1);",
          "`namespace segment_intersection::subject`: put all"},
         {"TEST_CASE(\"a\") {} TEST_CASE(\"a\") {}", "Two of your tests have this name"},
         {"TEST_CASE(\"a\", \"[.]\") { CHECK(orientation({}, {}) == 0); }", "A tag hides this test"},
         {"", "has no TEST_CASE in it"}}));
    const Finished said = SectionSeven{}(tests);
    INFO(said.out << said.err);
    CHECK(said.code == 1);
    CHECK_THAT(said.out, ContainsSubstring(why));
}

TEST_CASE("the first test of each section, which a reader is sent to, compiles in the file that mytests makes") {
    if (sanitized) SKIP("not every section is built there");
    const Workspace workspace{.root = COURSE_ROOT, .build = COURSE_BUILD};
    const OwnFolder own{"first tests XXXXXX"};
    const std::string empty = "TEST_CASE(\"say here what must hold\") {\n}\n";
    for (const Section &section : workspace.sections()) {
        CAPTURE(section.name);
        const std::string tests = read_file(workspace.tests(section));
        const std::size_t first = tests.find("\nTEST_CASE("), end = tests.find("\n}\n", first);
        REQUIRE(end != tests.npos);
        std::string text = empty_own_tests(workspace, section);
        REQUIRE(contains(text, empty));
        text.replace(text.find(empty), empty.size(), tests.substr(first, end + 3 - first));
        write_file(own.path / "first.cpp", text);
        const std::string chapters = workspace.root / "chapters";
        const auto compiled = run({"g++", "-std=c++20", "-fsyntax-only", "-w", "-I" COURSE_ROOT "/tests",
                                   "-I" COURSE_ROOT "/tools", "-I" + chapters, "-I" + chapters + '/' + section.name,
                                   "-isystem", COURSE_EIGEN, (own.path / "first.cpp").string()});
        CHECK(compiled.err == "");
    }
}
