// `course update`: all that's the course's is renewed, and nothing that's the student's.

#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;
using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char *file_of_student = "exercises/07_wall_meeting.cpp";
constexpr const char *stub_file = "tests/07_wall_meeting/stub.cpp";
constexpr const char *beside = "exercises/07_wall_meeting.new.txt";
const std::string
    stub_before = "// 7.1 core\nint first() {\n    throw 1;\n}\n\n// 7.2 core\nint second() {\n    throw 2;\n}\n",
    stub_after = "// 7.1 core\nint first() {\n    throw 1;\n}\n\n// 7.2 core\nint second(int of) {\n    throw 2;\n}\n";

/// A student's course, and a newer version of it beside it.
struct TwoVersions {
    TwoVersions() {
        for (const SmallCourse *each : {&student, &newer}) {
            each->write("course", "#!/bin/sh\n");
            for (const char *file : {file_of_student, stub_file})
                each->write(file, each == &newer ? stub_after : stub_before);
        }
        newer.write("chapters/07_wall_meeting/README.md", "# 7, better\n");
        newer.write("chapters/07_wall_meeting/new.hpp", "new\n");
        fs::remove_all(newer.workspace.build);
        fs::remove(newer.workspace.root / "exercises/06_reflection.cpp"); // a section that has gone
    }
    /// The student's is a clone of what the newer one was once.
    void in_git() const {
        student.git({"init", "--quiet", "--initial-branch=main"});
        student.write(".gitignore", "/build/\n");
        student.write("old.txt", "old\n");
        student.commit("old");
        newer.write(".gitignore", "/build/\n");
        newer.git({"init", "--quiet", "--initial-branch=main"});
        newer.git({"fetch", "--quiet", student.workspace.root.string(), "main"});
        newer.git({"reset", "--quiet", "FETCH_HEAD"});
        newer.commit("new");
    }
    Finished update() const { return student({"update", newer.workspace.root.string()}); }
    SmallCourse student{"a student XXXXXX"}, newer{"newer XXXXXX"};
};

} // namespace

TEST_CASE("an update renews the course, and puts a stub that has changed beside the student's file") {
    const TwoVersions course;
    const bool clone = GENERATE(false, true), of_old = GENERATE(false, true);
    if (of_old) { // where stubs were in 2026
        fs::remove(course.student.workspace.root / stub_file);
        course.student.write("tests/stubs/07_wall_meeting.cpp", stub_before);
    }
    if (clone) course.in_git();
    course.student.write(file_of_student, "int first() { return 1; } // mine\n");
    course.student.write("exercises/07_wall_meeting_tests.cpp", "// mine, too\n");
    const Finished done = course.update();
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK_THAT(done.out, ContainsSubstring("is yours, and stays. Its stub has changed (7.2 second)"));
    CHECK(course.student.read(file_of_student) == "int first() { return 1; } // mine\n");
    CHECK(course.student.read("exercises/07_wall_meeting_tests.cpp") == "// mine, too\n");
    CHECK(course.student.read(beside) == stub_after);
    CHECK(course.student.read(stub_file) == stub_after);
    if (clone) CHECK_FALSE(course.student.has("tests/stubs/07_wall_meeting.cpp"));
    CHECK(course.student.read("chapters/07_wall_meeting/README.md") == "# 7, better\n");
    CHECK(course.student.read("chapters/07_wall_meeting/new.hpp") == "new\n");
    CHECK_FALSE(course.student.has("old.txt"));
    CHECK(course.student.has("exercises/06_reflection.cpp")); // whatever was written there

    const Finished again = course.update();
    CHECK(again.out == "This is the newest version already.\n");
    if (clone) { // git knows no other change than the student's
        const Finished status = run({"git", "status", "--porcelain"}, {.folder = course.student.workspace.root});
        CHECK_THAT(status.out,
                   ContainsSubstring(" M exercises/07_wall_meeting.cpp\n") && !ContainsSubstring("chapters"));
    }
}

TEST_CASE("an exercise that nobody has begun becomes the new stub") {
    const TwoVersions course;
    CHECK(course.update().code == 0);
    CHECK(course.student.read(file_of_student) == stub_after);
    CHECK_FALSE(course.student.has(beside));
}

TEST_CASE("a stub that only says that it came with other tests is no changed stub") {
    const TwoVersions course;
    const std::string before = "// Handed out with tests 000000000000 (0.1.0).\n",
                      now = "// Handed out with tests 111111111111 (0.2.0).\n";
    const auto hand_out = [](const SmallCourse &to, const std::string &stamp) {
        for (const char *file : {file_of_student, stub_file}) to.write(file, stub_before + stamp);
    };
    hand_out(course.student, before);
    hand_out(course.newer, now);
    const bool begun = GENERATE(false, true);
    const std::string mine = "int first() { return 1; }\n" + before;
    if (begun) course.student.write(file_of_student, mine);
    const Finished done = course.update();
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK_THAT(done.out, !ContainsSubstring("is yours, and stays"));
    CHECK(course.student.read(file_of_student) == (begun ? mine : stub_before + now));
    CHECK(course.student.read(stub_file) == stub_before + now);
    CHECK_FALSE(course.student.has(beside));
}

TEST_CASE("what a student has committed stays in the history") {
    const TwoVersions course;
    course.in_git();
    course.student.write(file_of_student, "// mine\n");
    course.student.commit("mine");
    const Finished done = course.update();
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK(course.student.read(file_of_student) == "// mine\n");
    const Finished log = run({"git", "log", "--format=%s"}, {.folder = course.student.workspace.root});
    CHECK_THAT(log.out, ContainsSubstring("mine\n") && ContainsSubstring("new\n"));
    CHECK(run({"git", "diff", "--name-only", "FETCH_HEAD", "--", ".", ":!exercises"},
              {.folder = course.student.workspace.root})
              .out.empty());
}

TEST_CASE("what a student has changed beside the exercises isn't written over") {
    const TwoVersions course;
    course.in_git();
    course.student.write("chapters/07_wall_meeting/README.md", "# my notes\n");
    const Finished refused = course.update();
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, ContainsSubstring("you have changed chapters/07_wall_meeting/README.md"));
    CHECK(course.student.read("chapters/07_wall_meeting/README.md") == "# my notes\n");
}

TEST_CASE("an update of a clone that was stopped half-way goes on") {
    const TwoVersions course;
    course.in_git();
    course.student.write(file_of_student, "// mine\n");
    course.student.write("chapters/07_wall_meeting/README.md", "# 7, better\n"); // renewed before it was stopped
    course.student.write("chapters/07_wall_meeting/new.hpp", "new\n");           // new
    fs::remove(course.student.workspace.root / "old.txt");                       // gone
    const Finished done = course.update();
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK(course.student.read(stub_file) == stub_after);
    CHECK(course.student.read(file_of_student) == "// mine\n");
    CHECK(course.update().out == "This is the newest version already.\n");
}

TEST_CASE("an archive that leads out of its folder is refused, and nothing of it is unpacked") {
    const TwoVersions course;
    const OwnFolder downloads{"downloads XXXXXX"};
    const fs::path archive = downloads.path / "new.tar", root = course.newer.workspace.root;
    const auto tar = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"tar", "-C", root.string(), "-cPf", archive.string()});
        REQUIRE(run(words).code == 0);
    };
    fs::create_symlink(course.student.workspace.root / "exercises", root / "link");
    course.newer.write("evil.txt", "evil\n");
    const auto [words, why] = GENERATE(table<std::vector<std::string>, std::string>({
        {{"--transform=s|^evil.txt|../evil.txt|", ".", "evil.txt"}, "leads out of its folder"},
        {{"--transform=s|^evil.txt|/tmp/evil-of-an-update.txt|", ".", "evil.txt"}, "begins at the root of the disk"},
        {{"."}, "has a link in it"},
    }));
    tar(words);
    const Finished refused = course.student({"update", archive.string()});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, ContainsSubstring(why) && ContainsSubstring("Nothing was unpacked"));
    CHECK_FALSE(fs::exists("/tmp/evil-of-an-update.txt"));
    CHECK_FALSE(course.student.has("chapters/07_wall_meeting/new.hpp"));
}

TEST_CASE("an update comes from an archive, too, and from nothing else") {
    const TwoVersions course;
    const OwnFolder downloads{"downloads XXXXXX"};
    const fs::path archive = downloads.path / "new.tar.gz";
    REQUIRE(run({"tar", "czf", archive.string(), "-C", course.newer.folder.path.parent_path().string(),
                 course.newer.folder.path.filename().string()})
                .code
            == 0);
    CHECK(course.student({"update", archive.string()}).code == 0);
    CHECK(course.student.read("chapters/07_wall_meeting/new.hpp") == "new\n");
    course.student.write("no archive", "text");
    for (const std::string &wrong : {(course.student.workspace.root / "no archive").string(),
                                     (course.student.workspace.root / "tests").string(), std::string{"nowhere"}}) {
        const Finished refused = course.student({"update", wrong});
        CHECK(refused.code == 2);
        CHECK_FALSE(refused.err.empty());
    }
}

TEST_CASE("a folder for temporary files that isn't there is named, with the remedy") {
    const TwoVersions course;
    const Finished refused = course.student({"update", course.newer.workspace.root.string()}, {"TMPDIR=/nowhere"});
    CHECK(refused.code == bad_input);
    CHECK_THAT(refused.err, ContainsSubstring("there's no folder /nowhere for temporary files: set TMPDIR to one"));
}
