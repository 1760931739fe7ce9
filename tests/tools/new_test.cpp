// `course dev new`: a section's skeleton, in a small course, and once in a copy of this one, where it is built and judged.

#include "small_course.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"
#include "book/contents.hpp"
#include "figures/trace.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;
using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char *a_book =
    "# The book\n\n## Contents\n\n| | chapter | minutes |\n|--:|:--|--:|\n"
    "| 6 | [Reflection](chapters/06_reflection/README.md) | 60 |\n"
    "| 7 | [Walls that meet](chapters/07_wall_meeting/README.md) | 90 |\n"
    "| 8 | Collisions | to come |\n| 12 | Time | to come |\n\n| 8 | a table of its own |\n\n## Glossary\n";

/// What a new section consists of.
const std::set<std::string> files_of_springs{"chapters/13_springs/README.md",   "chapters/13_springs/main.cpp",
                                             "chapters/13_springs/springs.hpp", "exercises/13_springs.cpp",
                                             "plots/13_springs_pull.gp",        "plots/13_springs_pull.svg",
                                             "plots/13_springs_pull.tsv",       "solutions/13_springs.cpp",
                                             "tests/13_springs/tests.cpp",      "tests/13_springs/variants/by_side.cpp",
                                             "tests/13_springs/stub.cpp",       "tests/13_springs/mutants.diff"};

/// Every file below a folder, and what stands in it.
std::map<std::string, std::string> snapshot(const fs::path &root) {
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator{root})
        if (entry.is_regular_file() && !entry.is_symlink() && entry.path().filename() != "lock")
            files[entry.path().lexically_relative(root).generic_string()] = read_file(entry.path());
    return files;
}

/// A small course that has what `new` needs.
struct Author : SmallCourse {
    Author() {
        write("book.md", a_book);
        fs::create_directories(workspace.root / "tools");
        fs::copy(fs::path{COURSE_ROOT} / "tools" / "skeleton", workspace.root / "tools" / "skeleton",
                 fs::copy_options::recursive);
    }
};

} // namespace

TEST_CASE("new writes every file of a section, its line and its entry, and changes nothing else") {
    const Author course;
    course.write("tools/skeleton/plots/99_skeleton_pull.svg", "<svg>a point at 99 px</svg>");
    const auto before = snapshot(course.workspace.root);
    const Finished done = course({"dev", "new", "13_springs", "--title", "Springs and so on"});
    CHECK(done.err.empty());
    REQUIRE(done.code == 0);
    const auto after = snapshot(course.workspace.root);

    std::set<std::string> written, changed;
    for (const auto &[file, text] : after) {
        const auto old = before.find(file);
        if (old == before.end()) written.insert(file);
        else if (old->second != text) changed.insert(file);
    }
    CHECK_THAT(after.at("book.md"),
               ContainsSubstring("| stiffness | spring constant | [13](chapters/13_springs/README.md#a-spring) |\n"));
    CHECK(written == files_of_springs);
    CHECK(changed == std::set<std::string>{"CMakeLists.txt", "book.md"});
    CHECK(after.size() == before.size() + written.size());
    for (const std::string &file : written) CHECK_THAT(done.out, ContainsSubstring("  " + file + "\n"));

    CHECK(after.at("CMakeLists.txt")
          == "project(x)\nsection(06_reflection)\nsection(07_wall_meeting)\nsection(13_springs)\n");
    CHECK_THAT(after.at("book.md"),
               ContainsSubstring(
                   "| 12 | Time | to come |\n| 13 | [Springs and so on](chapters/13_springs/README.md) | |\n\n"));
    CHECK_THAT(after.at("chapters/13_springs/README.md"),
               StartsWith("# 13 Springs and so on\n") && ContainsSubstring("`./course plot 13 --mine`"));
    CHECK_THAT(after.at("chapters/13_springs/springs.hpp"),
               ContainsSubstring("namespace springs {")
                   && ContainsSubstring("COURSE_EXERCISE(\"13.1\", core, springs, pull"));
    CHECK(after.at("plots/13_springs_pull.svg") == "<svg>a point at 99 px</svg>"); // a drawing is no text
    CHECK(after.at("tests/13_springs/stub.cpp") == after.at("exercises/13_springs.cpp"));
    for (const std::string &file : written)
        if (!file.ends_with(".svg")) {
            CAPTURE(file);
            CHECK(after.at(file).find("keleton") == std::string::npos);
            CHECK(after.at(file).find("99") == std::string::npos);
        }
    CHECK(course.workspace.section("springs").number() == 13);
}

TEST_CASE("without a title a section takes the one that it has to come, or one made from its name") {
    const Author course;
    CHECK(course({"dev", "new", "08_nt_collisions"}).code == 0);
    CHECK_THAT(course.read("chapters/08_nt_collisions/README.md"), StartsWith("# 8 Collisions\n"));
    CHECK(course({"dev", "new", "13_coupled_springs"}).code == 0);
    CHECK_THAT(course.read("chapters/13_coupled_springs/README.md"), StartsWith("# 13 Coupled springs\n"));
    CHECK_THAT(
        course.read("book.md"),
        ContainsSubstring("| 8 | [Collisions](chapters/08_nt_collisions/README.md) | |\n| 12 | Time | to come |\n"
                          "| 13 | [Coupled springs](chapters/13_coupled_springs/README.md) | |\n"));
}

TEST_CASE("new refuses a malformed or taken name, says the right form, and writes nothing") {
    const Author course;
    const auto [name, says] = GENERATE(table<std::string, std::string>({
        {"springs", "as in 13_springs"},
        {"13-Springs", "as in 13_springs"},
        {"8 elastic Collisions", "as in 08_elastic_collisions"},
        {"8.gas", "as in 08_gas"},
        {"13_", "as in 13_springs"},
        {"13_2nd", "as in 13_springs"},
        {"13__springs", "as in 13_springs"},
        {"13_springs_", "two digits, an underscore, and small letters"},
        {"../13_springs", "two digits, an underscore, and small letters"},
        {"130_springs", "two digits, an underscore, and small letters"},
        {"00_springs", "counted from 01"},
        {"07_springs", "section 7 is there already: 07_wall_meeting; the next free number is 8"},
        {"13_reflection", "there is a section of that name already: 06_reflection"},
        {"13_while", "`while` is a word of C++"},
        {"13_time", "`time` is a word of C++ or of a library"},
        {"13_course", "`course` is a word"},
    }));
    const auto before = snapshot(course.workspace.root);
    const Finished said = course({"dev", "new", name});
    CAPTURE(name, said.err);
    CHECK(said.code == 2);
    CHECK_THAT(said.err, StartsWith("course: ") && ContainsSubstring(says));
    CHECK(snapshot(course.workspace.root) == before);
}

TEST_CASE("new overwrites nothing: if one file is in its way, it writes none") {
    const Author course;
    const std::string file =
        GENERATE("exercises/13_springs.cpp", "tests/13_springs/stub.cpp", "plots/13_springs_pull.svg");
    course.write(file, "mine");
    const auto before = snapshot(course.workspace.root);
    const Finished said = course({"dev", "new", "13_springs"});
    CHECK(said.code == 2);
    CHECK_THAT(said.err, ContainsSubstring(file + " is there already"));
    CHECK(snapshot(course.workspace.root) == before);
}

TEST_CASE("under a file-size limit, new writes all of a section or none of it") {
    const Author course; // whose longest file has 13 KB
    const auto before = snapshot(course.workspace.root);
    std::vector<std::string> command{"sh", "-c", "ulimit -f 8; exec \"$@\"", "sh"}; // [512 bytes], or kilobytes
    for (const std::string &word : course.command({"dev", "new", "13_springs"})) command.push_back(word);
    const Finished said = run(command);
    CHECK(said.code == 4);
    CHECK_THAT(said.err, ContainsSubstring("the disk is full"));
    CHECK(snapshot(course.workspace.root) == before);
    CHECK(course({"dev", "new", "13_springs"}).code == 0);
}

TEST_CASE("new leaves no file, folder or row behind when it can't write the last one") {
    const Author course;
    const fs::path last = course.workspace.root / "tests" / "13_springs"; // a file where its folder belongs
    course.write("tests/13_springs", "in the way");
    const auto before = snapshot(course.workspace.root);
    const Finished said = course({"dev", "new", "13_springs"});
    CHECK(said.code == 2);
    CHECK(snapshot(course.workspace.root) == before);
    CHECK_FALSE(course.has("chapters/13_springs"));
    fs::remove(last);
    CHECK(course({"dev", "new", "13_springs"}).code == 0);
}

TEST_CASE("without a place for it in CMakeLists.txt or book.md, or with a title of two lines, nothing is written") {
    const Author course;
    const auto refuses = [&](const std::vector<std::string> &words, const std::string &says) {
        const auto before = snapshot(course.workspace.root);
        const Finished said = course(words);
        CHECK(said.code == 2);
        CHECK_THAT(said.err, ContainsSubstring(says));
        CHECK(snapshot(course.workspace.root) == before);
    };
    refuses({"dev", "new", "13_springs", "--title", "two\nlines"}, "a title is one line");
    course.write("book.md", "# no contents\n");
    refuses({"dev", "new", "13_springs"}, "book.md has no contents");
    course.write("book.md", a_book);
    course.write("CMakeLists.txt", "project(x)\n");
    refuses({"dev", "new", "13_springs"}, "CMakeLists.txt has no line like section(07_segment_intersection)");
}

TEST_CASE("a section's line comes where its number belongs") {
    const std::string lists = "project(x)\n\nsection(06_a) # a\n  section(08_b)\n# section(09_c)\n\nfinish()\n";
    CHECK(with_section(lists, {"03_x"})
          == "project(x)\n\nsection(03_x)\nsection(06_a) # a\n  section(08_b)\n# section(09_c)\n\nfinish()\n");
    CHECK(with_section(lists, {"07_x"})
          == "project(x)\n\nsection(06_a) # a\nsection(07_x)\n  section(08_b)\n# section(09_c)\n\nfinish()\n");
    CHECK(with_section(lists, {"13_x"})
          == "project(x)\n\nsection(06_a) # a\n  section(08_b)\nsection(13_x)\n# section(09_c)\n\nfinish()\n");
}

TEST_CASE("an entry of the contents comes where its number belongs, and one to come gives way to it") {
    const std::string eight = with_entry(a_book, {"08_nt_collisions"}, "Collisions in n-t");
    CHECK_THAT(eight, ContainsSubstring("| 90 |\n| 8 | [Collisions in n-t](chapters/08_nt_collisions/README.md) | |\n| "
                                        "12 | Time | to come |\n\n| 8 | a table of its own |\n"));
    CHECK(eight.find("| 8 | Collisions | to come |") == std::string::npos);
    CHECK_THAT(with_entry(a_book, {"01_motion"}, "Motion"),
               ContainsSubstring("|--:|:--|--:|\n| 1 | [Motion](chapters/01_motion/README.md) | |\n| 6 | "));
    CHECK_THAT(with_entry(a_book, {"13_x"}, "X"),
               ContainsSubstring("| 12 | Time | to come |\n| 13 | [X](chapters/13_x"));
    CHECK(with_entry("|||\r\n|-|-|\r\n| 6 | Six |\r\n", {"07_x"}, "X")
          == "|||\r\n|-|-|\r\n| 6 | Six |\r\n| 7 | [X](chapters/07_x/README.md) |\r\n");
}

// The whole way, in a copy of this course: half a minute, most of it compiling.
TEST_CASE("a new section configures, builds, is drawn, woven and judged, and nothing else has changed",
          "[new][configure]") {
    const SmallCourse place; // for its folder
    const Workspace copy{.root = place.workspace.root / "copy", .build = place.workspace.root / "copy's build"};
    copy_course(copy.root);
    const std::string path = place.instead_of("gdb", "exit 0");
    const auto course = [&](const std::vector<std::string> &words) { return run(course_command(copy, words, {path})); };
    const auto succeeds = [](const Finished &done) {
        INFO(done.out << done.err);
        REQUIRE(done.code == 0);
    };

    const auto before = snapshot(copy.root);
    succeeds(course({"dev", "new", "14_springs"}));
    const auto after = snapshot(copy.root);
    CHECK(after.size() == before.size() + files_of_springs.size());
    for (const auto &[file, text] : before)
        if (file != "CMakeLists.txt" && file != "book.md" && after.at(file) != text) FAIL(file << " has changed");
    CHECK(after.at("CMakeLists.txt") != before.at("CMakeLists.txt"));
    CHECK_THAT(after.at("book.md"), ContainsSubstring("](chapters/14_springs/README.md)"));

    const auto settings = nlohmann::json::parse(read_file(fs::path{COURSE_BUILD} / "course.json"));
    succeeds(run({"cmake", "-S", copy.root.string(), "-B", copy.build.string(), "-G", "Ninja", "-DCOURSE_QUICK=OFF",
                  "-DCMAKE_CXX_COMPILER=" + settings.at("compiler").get<std::string>()}));
    std::vector<std::string> build{"cmake", "--build", copy.build.string(), "--target"};
    for (const char *target : {"14_springs", "14_springs_loop", "14_springs_subject_solution",
                               "14_springs_subject_stub", "14_springs_author"})
        build.push_back(target);
    const Finished built = run(build);
    succeeds(built);
    CHECK(built.out.find("warning:") == std::string::npos);
    const Finished tested = run({"ctest", "--test-dir", copy.build.string(), "--output-on-failure", "-R",
                                 "^14_springs\\.(solution|stub|answers)"});
    succeeds(tested);
    CHECK_THAT(tested.out, ContainsSubstring("100% tests passed, 0 tests failed out of 3"));

    const Finished untouched = course({"check", "14"});
    CHECK(untouched.code == 1);
    CHECK_THAT(untouched.out, ContainsSubstring("14.1 pull, core: not started"));
    succeeds(course({"check", "14", "--file", copy.solution(copy.section("14")).string()}));

    const fs::path stamp = copy.build / "loop/14_springs.checked", tomorrow = copy.root / "cmake/dated_tomorrow";
    write_file(tomorrow, "");
    fs::last_write_time(tomorrow, fs::file_time_type::clock::now() + std::chrono::hours{24});
    CHECK(course({"check", "14"}).code == 1);
    const auto built_at = fs::last_write_time(stamp);
    CHECK(course({"check", "14"}).code == 1);
    CHECK(fs::last_write_time(stamp) == built_at); // once, and not with every check
    fs::remove(tomorrow);

    const Finished mine = course({"run", "14", "--mine"});
    CHECK(mine.code == 1);
    CHECK_THAT(mine.err, ContainsSubstring(": needs pull: "));
    const Finished debug = course({"debug", "14.1", "--print"});
    succeeds(debug);
    CHECK_THAT(debug.out, StartsWith("gdb -q -ex 'break springs::pull' --args "));
    CHECK(run({(copy.build / "debug" / "14_springs").string(), "[14.1]"}).code != 0); // not started

    const fs::path traces = copy.build / "traces", trace = traces / "14_springs_pull.tsv",
                   svg = copy.build / "pull.svg";
    fs::create_directories(traces);
    succeeds(run({(copy.build / "chapters" / "14_springs").string(), "--out", traces.string()}));
    succeeds(course({"draw", "--script", (copy.root / "plots" / "14_springs_pull.gp").string(), "--trace",
                     trace.string(), "--out", svg.string()}));
    CHECK(rounded(read_trace(trace, "the trace")) == after.at("plots/14_springs_pull.tsv"));

    succeeds(course({"dev", "weave", "14"}));
    succeeds(course({"dev", "weave", "--check", "14"}));
    CHECK(read_file(copy.chapter(copy.section("14")))
          == after.at("chapters/14_springs/README.md")); // nothing was left to weave
}

TEST_CASE("what a page says that `new` makes isn't there already") {
    const std::filesystem::path root = COURSE_ROOT;
    for (const char *page :
         {"README.md", "CONTRIBUTING.md", "docs/authors.md", "docs/front.md", "docs/instructors.md"}) {
        const std::string text = read_file(root / page), command = "./course dev new ";
        for (std::size_t at = 0; (at = text.find(command, at)) != text.npos;) {
            at += command.size();
            CAPTURE(page, text.substr(at, 20));
            const auto number = leading_number(std::string_view{text}.substr(at));
            REQUIRE(number);
            for (const Section &section : Workspace{.root = root, .build = COURSE_BUILD}.sections())
                CHECK(section.number() != *number);
        }
    }
}
