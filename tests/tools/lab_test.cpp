// A course for many: built by somebody else, and not the student's to write.

#include "base/build.hpp"
#include "base/lab.hpp"
#include "check/build_config.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <nlohmann/json.hpp>

using Catch::Matchers::ContainsSubstring;
using namespace course;
namespace fs = std::filesystem;

namespace {

/// A small course, and a student of it, whose folder has a blank in its name.
struct Lab : SmallCourse {
    Lab() { workspace.home = workspace.root / "home of ann"; }
    Finished operator()(const std::vector<std::string> &words) const {
        return SmallCourse::operator()(words, {"COURSE_HOME=" + workspace.home.string()});
    }
    std::string read_own(const fs::path &file) const { return read_file(workspace.home / file); }
};

/// And a build of it, by a `ninja` that knows what these commands make.
struct BuiltLab : Lab {
    BuiltLab() {
        create_student_folder(workspace);
        write("build/default/.ninja_log", "");
        write("build/default/page.o", "page ");
        write("build/default/server.o", "built");
        write("build/default/play/07_mine.o.broken", "ours ");
        const std::string in_build = "cd '" + workspace.build.string() + "' && ",
                          play = workspace.build.string() + "/play/07_mine",
                          exercise = workspace.root.string() + "/exercises/07_wall_meeting.cpp",
                          note = workspace.build.string() + "/CMakeFiles/d/1.d";
        step("page.o", in_build + "exit 1");
        step("play/07_mine.o.broken", in_build + "exit 2");
        step("play/07_mine.o", in_build + "cat \"" + exercise + "\" \"" + play + ".o.broken\" > \"" + play
                                   + ".o\" && echo >> \"" + workspace.home.string() + "/runs\" && : > \"" + note + '"');
        step("play/07_mine.js", ": && cat page.o play/07_mine.o > \"" + play + ".wasm\" && cat \"" + play
                                    + ".wasm\" > \"" + play + ".js\"");
        step("loop/06_reflection_yours.o", in_build + "cp \"" + workspace.root.string()
                                               + "/exercises/06_reflection.cpp\" \"" + workspace.build.string()
                                               + "/loop/06_reflection_yours.o\"");
        step("tests/07_wall_meeting", ": && cat loop/06_reflection_yours.o server.o > tests/07_wall_meeting && :");
        write("compdb", database.dump());
        write("commands", commands);
    }
    template <class Do> auto with_ninja(Do what) const {
        const OnlyPath path{instead_of("ninja", "case \"$4\" in compdb|commands) cat '" + workspace.root.string()
                                                    + "'/\"$4\" ;; *) exit 1 ;; esac")
                                .substr(5)};
        return what();
    }
    /// Brings the student's up to date.
    Finished build() const {
        return with_ninja([&] { return build_target(workspace, "07_wall_meeting_play_mine"); });
    }
    int runs() const {
        const std::string lines = fs::exists(workspace.home / "runs") ? read_own("runs") : "";
        return static_cast<int>(lines.size());
    }

  private:
    void step(const std::string &output, const std::string &command) {
        commands += command + '\n';
        database.push_back({{"command", command}, {"output", output}, {"file", ""}, {"directory", ""}});
    }
    std::string commands;
    nlohmann::json database;
};

} // namespace

TEST_CASE("a student's first command in a course for many makes a folder with empty exercises, and says where") {
    const Lab lab;
    lab.write(lab.workspace.root / "exercises/07_wall_meeting.cpp", "// its owner's\n");
    const Finished first = lab({"list"});
    CHECK(first.code == all_well);
    CHECK_THAT(first.err, ContainsSubstring("Your exercises are in " + (lab.workspace.home / "exercises").string()));
    CHECK(lab.read_own("exercises/07_wall_meeting.cpp") == "// 07_wall_meeting, nothing done yet\n");
    CHECK_THAT(lab.read_own("chapters/07_wall_meeting/README.md"), ContainsSubstring("Walls that meet"));

    write_file(lab.workspace.home / "exercises/07_wall_meeting.cpp", "// mine\n");
    const Finished reset = lab({"reset", "7", "--yes"});
    CHECK(reset.err == "");
    CHECK_THAT(reset.out, ContainsSubstring("exercises/07_wall_meeting.cpp is the empty one again")
                              && ContainsSubstring("Yours is kept: .course/kept/"));
    CHECK(lab({"hint", "7.1"}).code == all_well);
    CHECK_FALSE(lab.has(".course"));
    CHECK(lab.read("exercises/07_wall_meeting.cpp") == "// its owner's\n");
}

TEST_CASE("what takes too much room for many says that it needs a course of one's own") {
    const Lab lab;
    for (const std::vector<std::string> &words : std::vector<std::vector<std::string>>{
             {"debug", "7"}, {"mytests", "7"}, {"site", "--mine"}, {"open", "7", "--mine"}, {"update", "x"}}) {
        const Finished done = lab(words);
        CAPTURE(words.front(), done.err);
        CHECK(done.code == bad_input);
        CHECK_THAT(done.err, ContainsSubstring("it needs a course of your own"));
    }
}

TEST_CASE("what's built of a student's file lies in the student's folder, and the build stays as it was") {
    const BuiltLab lab;
    write_file(lab.workspace.home / "exercises/07_wall_meeting.cpp", "mine ");
    const Finished done = lab.build();
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK(read_file(lab.workspace.work() / "play/07_mine.js") == "page mine ours ");
    CHECK(files_in(lab.workspace.build / "play").size() == 1);
    CHECK_FALSE(fs::exists(lab.workspace.build / "CMakeFiles"));
    CHECK_FALSE(fs::exists(lab.workspace.work() / "CMakeFiles/d"));
}

TEST_CASE("what's built of a student's file is built again only when the file has changed, or the course") {
    const BuiltLab lab;
    REQUIRE(lab.build().code == 0);
    REQUIRE(lab.build().code == 0);
    REQUIRE(lab.with_ninja([&] { return build_target(lab.workspace, "site"); }).code
            == 0); // which `play` brings up first
    CHECK(lab.runs() == 1);
    write_file(lab.workspace.home / "exercises/07_wall_meeting.cpp", "mine now ");
    REQUIRE(lab.build().code == 0);
    CHECK(lab.runs() == 2);
    CHECK(read_file(lab.workspace.work() / "play/07_mine.js") == "page mine now ours ");
    fs::last_write_time(lab.workspace.build / ".ninja_log", fs::file_time_type::clock::now());
    REQUIRE(lab.build().code == 0);
    CHECK(lab.runs() == 3);
}

TEST_CASE("in a handout for many, a later section is judged on what this student wrote for an earlier one") {
    const BuiltLab lab;
    const std::string build = lab.workspace.build.string() + '/';
    for (const char *file : {"missing.o", "tests/07_wall_meeting"}) lab.write(lab.workspace.build / file, "built");
    const nlohmann::json compiler{{"compiler", "c++"}, {"flags", nlohmann::json::array()}, {"precompiled", {"x"}}};
    nlohmann::json course = compiler;
    course.update(
        {{"nm", "nm"}, {"objcopy", "objcopy"}, {"node", "node"}, {"link", {"-x"}}, {"includes", {"/usr/include"}}});
    course["sections"] = {{{"name", "07_wall_meeting"},
                           {"server", build + "server.o"},
                           {"missing", build + "missing.o"},
                           {"ours", ""},
                           {"earlier", {build + "loop/06_reflection_yours.o"}}}};
    lab.write(lab.workspace.build / "course.json", course.dump());
    const BuildConfig tools = build_config(lab.workspace, lab.seven());
    const fs::path object = lab.workspace.work() / "loop/06_reflection_yours.o";
    REQUIRE(tools.earlier == std::vector{object.string()});
    for (const char *text : {"// what I wrote\n", "// what I wrote then\n"}) {
        write_file(lab.workspace.home / "exercises/06_reflection.cpp", text);
        lab.with_ninja([&] {
            bring_up_to_date(lab.workspace, lab.seven(), tools);
            return 0;
        });
        CHECK(read_file(object) == text);
        CHECK(read_file(lab.workspace.test_program(lab.seven())) == text + std::string{"built"});
    }
    fs::remove(lab.workspace.build / "server.o");
    CHECK_THROWS_AS(bring_up_to_date(lab.workspace, lab.seven(), tools), EnvironmentError);
}

TEST_CASE("there's room for what's built of one section, and its traces and figures stay") {
    const BuiltLab lab;
    const std::vector<std::string> others{"play/06_mine.js", "mine/06_reflection", "tests/06_reflection",
                                          "CMakeFiles/06_mine.dir/a.o"},
        kept{"mine/traces/06_reflection/a.tsv", "plots/mine/06_a.svg", "loop/06_reflection_yours.o"};
    for (const auto &files : {others, kept})
        for (const std::string &file : files) write_file(lab.workspace.work() / file, "");
    REQUIRE(lab.build().code == 0);
    for (const std::string &file : others) CHECK_FALSE(fs::exists(lab.workspace.work() / file));
    for (const std::string &file : kept) CHECK(fs::exists(lab.workspace.work() / file));
}

TEST_CASE("a course for many that lacks something says what its owner has to type") {
    const BuiltLab lab;
    fs::remove(lab.workspace.build / "page.o");
    try {
        lab.build();
        FAIL("it was built");
    } catch (const EnvironmentError &trouble) {
        CHECK_THAT(trouble.what(), ContainsSubstring("page.o isn't there") && ContainsSubstring("--target lab"));
    }
}

TEST_CASE("a second user gets a verdict in a course that can't be written, and leaves no trace in it") {
    const OwnFolder folder;
    const fs::path course = fs::path{COURSE_ROOT} / "course", home = folder.path / "frame-by-frame";
    fs::permissions(folder.path, fs::perms::all);
    const auto as_another = [&](std::vector<std::string> words) {
        std::vector<std::string> command{"setpriv",
                                         "--reuid=65534",
                                         "--regid=65534",
                                         "--clear-groups",
                                         "env",
                                         "-u",
                                         "COURSE_LOCKED",
                                         "HOME=" + folder.path.string(),
                                         std::string{"COURSE_BUILD="} + COURSE_BUILD};
        command.insert(command.end(), words.begin(), words.end());
        return run(command);
    };
    if (::geteuid() != 0 || !in_path("setpriv") || as_another({"test", "-x", course.string()}).code != 0)
        SKIP("only root can be somebody else, and that one must reach the course");

    const Finished homeless = as_another({"env", "-u", "HOME", course.string(), "check", "7"});
    CHECK(homeless.code == bad_input);
    CHECK_THAT(homeless.err, ContainsSubstring("HOME isn't set: type COURSE_HOME=/some/folder " + course.string()));
    CHECK(as_another({course.string(), "check", "7"}).code == something_to);
    CHECK_THAT(read_file(home / "exercises/07_segment_intersection.cpp"), ContainsSubstring("NotYet"));
    write_file(home / "exercises/07_segment_intersection.cpp",
               read_file(fs::path{COURSE_ROOT} / "solutions/07_segment_intersection.cpp"));
    const Finished done = as_another({(home / "course").string(), "check", "7"});
    INFO(done.out << done.err);
    CHECK(done.code == all_well);
    CHECK_THAT(done.out, ContainsSubstring("All of section 7 passes."));
    CHECK_THAT(as_another({course.string(), "test"}).err, ContainsSubstring("not yours to build"));
    CHECK(run({"find", COURSE_BUILD, "-user", "65534", "-print", "-quit"}).out == "");
}
