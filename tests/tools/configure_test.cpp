// What CMake says of a course that lacks a file, has one too many, or has its exercise deleted.

#include "base/files.hpp"
#include "base/process.hpp"
#include "grade/handout.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

/// CMake breaks its lines anywhere.
std::string on_one_line(const course::Finished &said) {
    std::string text;
    for (const char c : said.err)
        if (c != '\n' && c != ' ') text += c;
        else if (!text.empty() && text.back() != ' ') text += ' ';
    return text;
}

/// A copy of this course's files, in a folder with blanks, configured but never built.
struct Copy {
    Copy() { course::copy_course(root); }

    course::Finished configure(const std::vector<std::string> &options = {}) const {
        std::vector<std::string> command{
            "cmake", "-G", "Ninja", "-S", root.string(), "-B", (root / "a build").string()};
        command.insert(command.end(), {"-DCOURSE_QUICK=OFF", "-DCOURSE_WASM_CLANG="}); // which take a while to try
        command.insert(command.end(), options.begin(), options.end());
        return course::run(command);
    }

    void is_refused(const std::string &sentence, const std::vector<std::string> &options = {}) const {
        const auto said = configure(options);
        CHECK(said.code != 0);
        CHECK_THAT(on_one_line(said), ContainsSubstring(sentence));
    }

    const course::OwnFolder folder;
    const fs::path &root = folder.path;
};

} // namespace

TEST_CASE("a section without its solution is a configure error that names the file", "[configure]") {
    const Copy copy;
    fs::remove(copy.root / "solutions/07_segment_intersection.cpp");
    copy.is_refused("needs solutions/07_segment_intersection.cpp, which is not there");
}

TEST_CASE("a handout configures without solutions, and has the tests of its stubs", "[configure]") {
    const Copy copy;
    course::make_handout(copy.root);
    REQUIRE(copy.configure().code == 0);
    const std::string tests = course::run({"ctest", "-N", "--test-dir", (copy.root / "a build").string()}).out;
    CHECK_THAT(tests, ContainsSubstring("07_segment_intersection.stub") && !ContainsSubstring(".solution"));
    CHECK_THAT(course::read_file(copy.root / "a build" / "course.json"),
               ContainsSubstring("09_forward_kinematics_yours.o"));
}

TEST_CASE("a file of no section is a configure error that names it", "[configure]") {
    const Copy copy;
    const std::string stray = GENERATE("solutions/07_segments.cpp", "tests/07_segments");
    course::write_file(copy.root / (stray.ends_with(".cpp") ? stray : stray + "/tests.cpp"), "");
    copy.is_refused(stray + " belongs to no section");
}

TEST_CASE("what else a student keeps in exercises/ is no concern of the course", "[configure]") {
    const Copy copy;
    course::write_file(copy.root / "exercises/07_old.cpp", "my first try, which does not even compile");
    course::write_file(copy.root / "exercises/notes.txt", "");
    CHECK(copy.configure().code == 0);
}

TEST_CASE("without its exercise the course still configures, and says the way back", "[configure]") {
    const Copy copy;
    fs::remove(copy.root / "exercises/07_segment_intersection.cpp");
    const auto said = copy.configure();
    CHECK(said.code == 0);
    CHECK_THAT(on_one_line(said), ContainsSubstring("`./course reset 7` brings the empty one back"));
}

TEST_CASE("a section builds on earlier sections only", "[configure]") {
    using Lines = std::vector<std::pair<std::string, std::string>>;
    const auto [lines, complaint] = GENERATE(table<Lines, std::string>(
        {{{{"section(11_particles", "section(11_particles BUILDS_ON 10_springs)"}},
          "section(11_particles BUILDS_ON 10_springs): no section(10_springs) stands above this line"},
         {{{"section(07_segment_intersection", "section(07_segment_intersection BUILDS_ON 11_particles)"}},
          "section(07_segment_intersection BUILDS_ON 11_particles): a section can only build on one with a smaller"},
         {{{"section(11_particles", "section(11_particles BUILDS_ON 11_particles)"}}, "on one with a smaller number"},
         {{{"section(07_segment_intersection", "section(07_segment_intersection BUILDS_ON 11_particles)"},
           {"section(11_particles", "section(11_particles BUILDS_ON 07_segment_intersection)"}}, // a cycle
          "section(07_segment_intersection BUILDS_ON 11_particles): a section can only build on one with a smaller"},
         {{{"section(11_particles", "section(11_particles 07_segment_intersection)"}},
          "after the name comes nothing, or BUILDS_ON and earlier sections, then PLAYS_YOURS or nothing, but not "
          "07_segment_intersection"}}));
    CAPTURE(complaint);
    const Copy copy;
    const fs::path list = copy.root / "CMakeLists.txt";
    std::string text = course::read_file(list);
    for (const auto &[begin, line] : lines) {
        const std::size_t at = text.find(begin);
        REQUIRE(at != text.npos);
        text.replace(at, text.find('\n', at) - at, line);
    }
    course::write_file(list, text);
    copy.is_refused(complaint);
}

TEST_CASE("a section without a figure is a configure error", "[configure]") {
    const Copy copy;
    for (const auto &entry : fs::directory_iterator{copy.root / "plots"})
        if (entry.path().extension() == ".gp" && entry.path().stem() != "style") fs::remove(entry.path());
    copy.is_refused("has no figure: write plots/");
}

TEST_CASE("the packages that peers need are asked for all at once, and only if peers are wanted", "[configure]") {
    const Copy copy;
    for (const std::string section : {"01_motion", "11_particles"})
        course::write_file(copy.root / "tests" / section / "peer.cpp",
                           "// needs No" + section + " no::no libno-" + section + "-dev\n");
    copy.is_refused("sudo apt install libno-01_motion-dev libcgal-dev libno-11_particles-dev",
                    {"-DCOURSE_PEERS=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON"});
    CHECK(copy.configure({"-DCOURSE_PEERS=OFF"}).code == 0);
}

TEST_CASE("a peer says in its first line what it needs", "[configure]") {
    const Copy copy;
    course::write_file(copy.root / "tests/01_motion/peer.cpp", "// needs CGAL\n");
    copy.is_refused("tests/01_motion/peer.cpp must begin with `// needs", {"-DCOURSE_PEERS=ON"});
}
