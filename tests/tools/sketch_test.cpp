// `course sketch` before anything is compiled; tests/site/sketch.test.mjs goes from there to the page.
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;

namespace course {
namespace {

constexpr const char *scene = R"x(#pragma once
// A ball.
#include "shared.hpp"

namespace play {
struct Lands : demo::Scene {
    static constexpr std::string_view name = "it lands (7.2)";
};
} // namespace play
)x";

TEST_CASE("a sketch has a name that a file and a struct can have, and is shared as a page") {
    const SmallCourse small;
    for (const char *bad : {"../moon", "Moon", "2moons", "moon.cpp"})
        CHECK_THAT(small({"sketch", bad}).err,
                   ContainsSubstring("name it by small letters, as in: ./course sketch moon"));
    CHECK_THAT(small({"sketch", "moon", "--share", "moon.cpp"}).err, ContainsSubstring("a name that ends in .html"));
    CHECK_FALSE(std::filesystem::exists(small.workspace.root / "exercises" / "sketches"));
}

TEST_CASE("a sketch is written once, and all are listed; what's missing is said after that") {
    const SmallCourse small;
    const Finished first = small({"sketch", "moon"});
    CHECK_THAT(first.out, ContainsSubstring("Written: exercises/sketches/moon.cpp\n"));
    CHECK(first.code == 2); // there is no compiler for pages
    CHECK_THAT(small.read("exercises/sketches/moon.cpp"),
               ContainsSubstring("struct Moon : Scene {") && ContainsSubstring("SKETCH(Moon, "));
    small.write("exercises/sketches/moon.cpp", "// mine\n");
    CHECK_THAT(small({"sketch", "moon"}).out, !ContainsSubstring("Written"));
    CHECK(small.read("exercises/sketches/moon.cpp") == "// mine\n");
    CHECK(small({"sketch"}).out == "./course sketch moon\nA new one: ./course sketch moon\n");
}

TEST_CASE("reset brings the first lines of a sketch back, and keeps a copy; where there is none it says so") {
    const SmallCourse small;
    small({"sketch", "moon"});
    const std::string first = small.read("exercises/sketches/moon.cpp");
    small.write("exercises/sketches/moon.cpp", "// mine\n");
    CHECK_THAT(small({"reset", "moon", "--sketch"}).err,
               ContainsSubstring("./course reset moon --sketch --yes does it"));
    CHECK(small.read("exercises/sketches/moon.cpp") == "// mine\n");

    CHECK_THAT(small({"reset", "moon", "--sketch", "--yes"}).out,
               ContainsSubstring("moon.cpp is the empty one again. Yours is kept: .course/kept/moon-20"));
    CHECK(small.read("exercises/sketches/moon.cpp") == first);
    REQUIRE(small.kept().size() == 1);
    CHECK(read_file(small.kept()[0]) == "// mine\n");

    for (const char *none : {"sun", "../sketches/moon", ""})
        CHECK_THAT(small({"reset", none, "--sketch", "--yes"}).err,
                   ContainsSubstring("there is no sketch `" + std::string{none} + '`'));
}

TEST_CASE("a sketch begins with a scene of the book, by its name or its file, but not over another sketch") {
    const SmallCourse small;
    small.write("chapters/07_wall_meeting/scenes/lands.hpp", scene);
    small.write("chapters/07_wall_meeting/scenes/shared.hpp", "// shared\n");
    for (const char *from : {"7/lands", "7/it lands", "wall/7.2"}) {
        std::filesystem::remove(small.workspace.root / "exercises" / "sketches" / "ball.cpp");
        CAPTURE(from);
        CHECK_THAT(small({"sketch", "ball", "--from", from}).out, ContainsSubstring("Written"));
        const std::string text = small.read("exercises/sketches/ball.cpp");
        CHECK_THAT(text, ContainsSubstring("#include \"sketch.hpp\"\n")
                             && ContainsSubstring("#include \"07_wall_meeting/scenes/shared.hpp\"\n")
                             && ContainsSubstring("SKETCH(play::Lands, \"it lands (7.2)\")\n"));
        CHECK_THAT(text, !ContainsSubstring("#pragma once"));
    }
    CHECK_THAT(small({"sketch", "ball", "--from", "7/lands"}).err,
               ContainsSubstring("is there already: take another name"));
    CHECK_THAT(small({"sketch", "cup", "--from", "7/jumps"}).err,
               ContainsSubstring("section 7 has no scene `jumps`; it has it lands (7.2)"));
    CHECK_THAT(small({"sketch", "cup", "--from", "6/any"}).err,
               ContainsSubstring("no scene `any` that could be copied yet"));
    CHECK_THAT(small({"sketch", "cup", "--from", "lands"}).err, ContainsSubstring("as 4/lands does"));
}

} // namespace
} // namespace course
