// `course export handout`: what's in it, what isn't, and that a line of ours that is left in it is found.

#include "base/text.hpp"
#include "check/which_tests.hpp"
#include "grade/handout.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace course;
namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A small course in a repository, with a solution whose second line tells how it's done.
struct HandedOutCourse : SmallCourse {
    HandedOutCourse() {
        write("CMakeLists.txt", "project(x VERSION 1.2.3)\nsection(07_wall_meeting)\n");
        write("README.md", "# A course\n\n## I teach with it\n\n[All of it](docs/instructors.md)\n\nMIT licence.\n");
        write("docs/instructors.md", "# For instructors\n");
        write("solutions/07_wall_meeting.cpp", solution_code);
        write("tests/07_wall_meeting/tests.cpp", "// tests\n");
        write("tests/07_wall_meeting/mutants.diff", "7.1 wrong\n");
        write("exercises/07_wall_meeting.cpp", "// mine\n");
        write("chapters/07_wall_meeting/README.md", chapter_before + bar + chapter_behind);
        write(".gitignore", "/build/\n/out/\n");
        git({"init", "--quiet"});
        commit();
    }
    Finished handout() const { return (*this)({"export", "handout", out.string()}); }
    std::string log_of_handout() const {
        return run({"git", "-C", (out / "frame-by-frame").string(), "log", "--format=%s"}).out;
    }
    /// What is found in a folder with this one file.
    std::vector<Finding> leaks_of(const std::string &file, const std::string &text) const {
        std::filesystem::remove_all(out);
        write_file(out / file, text);
        return leaks(workspace, out);
    }

    const std::filesystem::path out = workspace.root / "out";
    static constexpr const char *solution_code = "//> Solution 7.1: one\ndouble first(double x) {\n    return "
                                                 "std::max(0.0, x < 3 ? x * x * x : \"\"[0]);\n}\n//>\n";
    static inline const std::string chapter_before = "# 7 Walls\n\nText.\n\n",
                                    bar =
                                        std::string{
                                            "<details><summary>Our solution of 7.1</summary>\n\nLook:\n\n```cpp\n"}
                                        + solution_code + "```\n</details>\n\n",
                                    chapter_behind = "Three bugs to hunt: `./course bug 7`.\n\nThe end.\n";
};

} // namespace

TEST_CASE("a handout has chapters, exercises and stubs, and none of our answers") {
    const HandedOutCourse course;
    const Finished made = course.handout();
    INFO(made.err);
    REQUIRE(made.code == 0);
    CHECK(course.log_of_handout() == "Frame by Frame 1.2.3\n");
    for (const char *file : {"chapters/07_wall_meeting/README.md", "exercises/07_wall_meeting.cpp", "HANDOUT.md",
                             "tests/07_wall_meeting/stub.cpp", "tests/07_wall_meeting/tests.cpp"})
        CHECK(course.has("out/frame-by-frame/" + std::string{file}));
    const std::string stamp = stamp_of(which_tests(hash_of_tests(course.workspace, course.seven()), "1.2.3"));
    for (const char *file : {"exercises/07_wall_meeting.cpp", "tests/07_wall_meeting/stub.cpp"})
        CHECK(course.read("out/frame-by-frame/" + std::string{file})
              == read_file(course.workspace.stub(course.seven())) + stamp);
    for (const char *file : {"solutions", "tests/07_wall_meeting/mutants.diff", "docs/instructors.md"})
        CHECK(!course.has("out/frame-by-frame/" + std::string{file}));
    CHECK(course.read("out/frame-by-frame/chapters/07_wall_meeting/README.md") == "# 7 Walls\n\nText.\n\nThe end.\n");
    CHECK_THAT(course.read("out/frame-by-frame/HANDOUT.md"), ContainsSubstring("## What to hand in\n"));
    CHECK(course.read("out/frame-by-frame/README.md") == "# A course\n\nMIT licence.\n");
    const std::string packed =
        run({"cmake", "-E", "tar", "tf", (course.out / "frame-by-frame-1.2.3-handout.zip").string()}).out;
    CHECK_THAT(packed, ContainsSubstring("frame-by-frame/HANDOUT.md\n") && !ContainsSubstring("solution"));
}

TEST_CASE("a file in a handout says which tests it came with, and nothing else is taken for that") {
    const WhichTests tests{"5f3a2b1c9d0e", "0.9.0"};
    const std::string stamp = "// Handed out with tests 5f3a2b1c9d0e (0.9.0).\n";
    CHECK(stamp_of(tests) == stamp);
    const auto said = [](const std::string &text) {
        const auto its = stamp_in(text);
        return its ? its->digits + ' ' + its->version : "nothing";
    };
    CHECK(said("int x;\n" + stamp) == "5f3a2b1c9d0e 0.9.0");
    CHECK(said("int x;\r\n// Handed out with tests 5f3a2b1c9d0e (0.9.0).\r\nint y;") == "5f3a2b1c9d0e 0.9.0");
    CHECK(said(stamp + "// Handed out with tests 000000000000 (1.0).") == "000000000000 1.0");
    CHECK(said("int x;\n") == "nothing");
    for (const char *other : {"", " ", "5f3a2b1c9d0e", "5f3a2b1c9d0e (0.9.0", "5f3a2b1c9d0e ().", "5f3a2b1c9d0e (<b>).",
                              "5F3A2B1C9D0E (1).", "5f3a2b1c9d0 (0.9.0).", "5f3a2b1c9d0e (0.9.0). ",
                              "5f3a2b1c9d0e (111111111111111111111).", ").", " ()."})
        CHECK(said("// Handed out with tests " + std::string{other} + '\n') == "nothing");
    CHECK(without_stamp("int x;\n" + stamp) == "int x;\n");
    CHECK(without_stamp(stamp + "int x;\n") == stamp + "int x;\n");
}

TEST_CASE("the name of the tests changes with them, and not with how lines end") {
    const SmallCourse course;
    const auto hash_of = [&](const std::string &tests, const std::string &helpers) {
        course.write("tests/07_wall_meeting/tests.cpp", tests);
        course.write("tests/matchers.hpp", helpers);
        return hash_of_tests(course.workspace, course.seven());
    };
    const std::string one = hash_of("a\nb\n", "c\n");
    CHECK(one.size() == 64);
    CHECK(hash_of("a\r\nb\r\n", "c\n") == one);
    CHECK(hash_of("a\nb\n", "d\n") != one);
    CHECK(hash_of("a\n", "c\n") != one);
}

TEST_CASE("a second handout is a commit that students can pull, and keeps out of other folders") {
    const HandedOutCourse course;
    REQUIRE(course.handout().code == 0);
    REQUIRE(course.handout().code == 0);
    CHECK(course.log_of_handout() == "Frame by Frame 1.2.3\n"); // nothing is new
    course.write("chapters/07_wall_meeting/wall_meeting.hpp", "// new\n");
    CHECK_THAT(course.handout().err, ContainsSubstring("commit first, since a handout is made of what is committed"));
    course.commit();
    REQUIRE(course.handout().code == 0);
    CHECK(course.log_of_handout() == "Frame by Frame 1.2.3\nFrame by Frame 1.2.3\n");

    course.write("out/frame-by-frame/exercises/07_wall_meeting.cpp", "// tried\n");
    CHECK_THAT(course.handout().err, ContainsSubstring("somebody has changed"));
    CHECK(course.read("out/frame-by-frame/exercises/07_wall_meeting.cpp") == "// tried\n");

    std::filesystem::remove_all(course.out);
    course.write("out/frame-by-frame/mine.txt", "");
    CHECK_THAT(course.handout().err, ContainsSubstring("is there already, and is no handout"));
    CHECK(course.has("out/frame-by-frame/mine.txt"));
    course.write("out/frame-by-frame-online/mine.txt", "");
    CHECK_THAT(course({"export", "handout", course.out.string(), "--online"}).err,
               ContainsSubstring("frame-by-frame-online is there already, and is no handout to write in"));
    CHECK(course.has("out/frame-by-frame-online/mine.txt"));
}

TEST_CASE("what gives a solution away is found, and nothing is written") {
    const HandedOutCourse course;
    course.write("chapters/07_wall_meeting/notes.md", HandedOutCourse::bar);
    course.write("book.md", "[gone](docs/instructors.md)\n\nType `./course bug 7`.\n");
    course.write("chapters/course.txt", HandedOutCourse::solution_code);
    course.commit();
    const Finished made = course.handout();
    CHECK(made.code == 2);
    CHECK_THAT(made.err,
               ContainsSubstring("\nchapters/course.txt: has a line of our solution, solutions/07_wall_meeting.cpp:3")
                   && ContainsSubstring("\nbook.md:1: ") && ContainsSubstring("\nbook.md:3: names `./course bug`")
                   && !ContainsSubstring("notes.md"));
    CHECK(!course.has("out/frame-by-frame"));
}

TEST_CASE("a line of a solution is found in a page with colours, in a search index, and in a packed demo") {
    const HandedOutCourse course;
    CHECK(course.leaks_of("page.html", "<p>return std::max").empty());
    CHECK(course
              .leaks_of("page.html", "<b>return</b> std::<i class=\"x\">max</i>(0.0, x &lt; 3 ? x * x * x : "
                                     "&quot;&quot;[0]);")
              .size()
          == 1);
    CHECK(course.leaks_of("search.js", R"({"text": "return std::max(0.0,\n x < 3 ? x * x * x : \"\"[0]);"})").size()
          == 1);
    std::filesystem::create_directories(course.workspace.root / "tools" / "play");
    std::filesystem::copy(std::filesystem::path{COURSE_ROOT} / "tools/play/pack.cjs",
                          course.workspace.root / "tools/play");
    const auto pack = [&](const std::string &text) {
        course.write("packed", text);
        return run({"node", COURSE_ROOT "/tools/play/pack.cjs", (course.workspace.root / "packed").string(), "x"}).out;
    };
    CHECK(course.leaks_of("demo.js", pack(HandedOutCourse::solution_code)).size() == 1);
    CHECK(course.leaks_of("demo.js", pack("void f();")).empty());
}

TEST_CASE("what the chapter's own text tells, or the tests, is no leak") {
    const HandedOutCourse course;
    const std::string line = "return std::max(0.0, x < 3 ? x * x * x : \"\"[0]);";
    const std::string file = GENERATE("chapters/07_wall_meeting/README.md", "tests/07_wall_meeting/tests.cpp");
    course.write(file, "> | `" + line + "` | that's all |\n");
    CHECK(course.leaks_of("page.txt", line).empty());
}

TEST_CASE("of a bar with a solution and a frame loop, the frame loop stays") {
    const std::string before = "<details><summary>Our solution of 12.1, and the frame loop that calls it</summary>\n\n"
                               "```cpp\n//> Solution 12.1: fly\nreturn 1;\n```\n\n"
                               "```cpp\n//> Frame loop 1\nfly();\n```\n</details>\n\nText.\n";
    CHECK(page_in_handout("chapters/12/README.md", before)
          == "<details><summary>The frame loop that calls 12.1</summary>\n\n```cpp\n//> Frame loop 1\nfly();\n```\n"
             "</details>\n\nText.\n");
}

TEST_CASE("a page loses what needs our answers, and keeps what stands around it") {
    CHECK(page_in_handout("x.md", "| `./course list` | a |\n| `./course solution 1.2` | b |\n")
          == "| `./course list` | a |\n");
    CHECK(page_in_handout("x.md", "One.\n\n> **Your test (10 minutes).** Swap.\n> More.\n\nTwo.\n")
          == "One.\n\nTwo.\n");
    CHECK(page_in_handout("x.md", "- A?\n- How far can you trust our solutions?\n  Far.\n\n  Very.\n- B?\n")
          == "- A?\n- B?\n");
    const std::string measured =
        page_in_handout("x.md", "`./course dev bench pairs` measures all three ways on your machine.\n");
    CHECK(measured == "We measured all three ways.\n");
    CHECK(page_in_handout("README.md", "# A\n\n**[Read](https://a.example)**: x\n\n[![B.](c.svg)](https://a.example)\n")
          == "# A\n\n![B.](c.svg)\n"); // our solutions are there
    const std::string front =
        page_in_handout("docs/front.md", "**You teach?** [How](a.md).\n**You'd mend a line?** No.\nB.\n");
    CHECK(front == "B.\n");
}

TEST_CASE("the course's own handout gives nothing away, and no page of it leads nowhere") {
    const SmallCourse course;
    const fs::path made = course.workspace.root / "made";
    fs::create_directories(made);
    for (const auto &each : fs::directory_iterator{COURSE_ROOT})
        if (!is_any_of(each.path().filename().string(), {"build", ".git", ".course"}))
            fs::copy(each.path(), made / each.path().filename(), fs::copy_options::recursive);
    make_handout(made);
    const Workspace ours{.root = COURSE_ROOT, .build = COURSE_BUILD};
    for (const Finding &each : leaks(ours, made))
        FAIL_CHECK(each.file.string() << ':' << each.line << ": " << each.message);
}

TEST_CASE(
    "without solutions, commands that need them say so in one sentence, and a hint doesn't send anybody to them") {
    const SmallCourse course;
    std::filesystem::remove_all(course.workspace.root / "solutions");
    course.write(handout_mark, "");
    const auto [words, sentence] = GENERATE(
        std::pair{
            std::vector<std::string>{"solution", "7.2"},
            "course: this edition of the course has no solutions: your instructor has them. `./course hint 7.2` gives "
            "you a hint\n"},
        std::pair{std::vector<std::string>{"run", "7"},
                  "course: this edition of the course has no solutions: your instructor "
                  "has them. `./course run 7 --mine` runs the program with yours\n"});
    const Finished said = course(words);
    CHECK(said.code == 2);
    CHECK(said.err == sentence);
    CHECK_THAT(course({"hint", "7.1", "--all"}).out,
               ContainsSubstring("That was the last one. Still stuck? Ask your instructor.\n"));
}

TEST_CASE("a student's earlier file is linked with helpers of the same name, or with its stand-in where it's broken") {
    const SmallCourse course;
    const auto object = [&](const std::string &name, const std::string &code) {
        course.write(name + ".cpp", code);
        const std::string file = (course.workspace.root / name).string();
        REQUIRE(run({"sh", COURSE_ROOT "/cmake/compile_yours.sh", file + ".o", file + ".stand_in", "4" + name, "nm",
                     "objcopy", "c++", "-c", file + ".cpp"})
                    .code
                == 0);
        return file + ".o";
    };
    const auto result_of = [&](const std::string &program) {
        course.write("main.cpp", program);
        const std::string to = (course.workspace.root / "program").string();
        const Finished built =
            run({"c++", (course.workspace.root / "main.cpp").string(), (course.workspace.root / "wall.o").string(),
                 (course.workspace.root / "ball.o").string(), "-o", to});
        INFO(built.err);
        REQUIRE(built.code == 0);
        return run({to}).code;
    };
    const char *program =
        "namespace wall { int f(); } namespace ball { int f(); } int main() { return wall::f() + ball::f(); }";
    object("wall", "int help() { return 40; } namespace wall { int f() { return help(); } }");
    object("ball", "int help() { return 2; } namespace ball { int f() { return help(); } }");
    CHECK(result_of(program) == 42);
    std::filesystem::copy(course.workspace.root / "ball.o", course.workspace.root / "wall.stand_in");
    object("wall", "what?");
    CHECK(read_file(course.workspace.root / "wall.o") == read_file(course.workspace.root / "ball.o"));
}
