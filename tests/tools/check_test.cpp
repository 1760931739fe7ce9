// `course check` as a command: one exercise alone; with --watch again whenever the file changes, again at Enter, and
// gone at q. What it says of a file is in tests/verdicts.

#include "base/text.hpp"
#include "judge/runner/sandbox.hpp"
#include "small_course.hpp"
#include "whole_answer.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

namespace {

std::size_t count(const std::string &text, const std::string &what) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += what.size()) ++found;
    return found;
}

/// The answer that is judged; a file for each process, since tests run side by side.
fs::path checked() { return fs::path{COURSE_BUILD} / ("checked_" + std::to_string(::getpid()) + ".cpp"); }

std::vector<std::string> check_command(const std::string &what, const std::string &file, const fs::path &build) {
    const fs::path root = COURSE_ROOT;
    course::write_file(checked(), whole_answer(root / file, root / "tests/verdicts/rest.hpp"));
    return course::course_command({root, build}, {"check", what, "--file", checked().string()});
}

course::Finished check(const std::string &what, const std::string &file) {
    auto done = course::run(check_command(what, file, COURSE_BUILD));
    fs::remove(checked());
    return done;
}

/// `./course check words`, in this course or with another build folder of it.
course::Finished check(std::vector<std::string> words, const fs::path &build = COURSE_BUILD) {
    words.insert(words.begin(), "check");
    return course::run(course::course_command({COURSE_ROOT, build}, words), {.deadline = 30});
}

/// A build folder that is this one, but for its compiler and an empty folder to work in.
struct OtherBuild {
    explicit OtherBuild(const std::string &compiler_script) {
        const fs::path built = COURSE_BUILD;
        fs::create_directories(work);
        course::link_all_but({"loop", "course.json", "site"}, built, folder);
        auto json = nlohmann::json::parse(course::read_file(built / "course.json"));
        if (!compiler_script.empty()) {
            const fs::path compiler = folder / "compiler";
            course::write_file(compiler, "#!/bin/sh\n" + compiler_script + '\n');
            fs::permissions(compiler, fs::perms::all);
            json["compiler"] = compiler.string();
        }
        course::write_file(folder / "course.json", json.dump());
        course::write_file(work / "07_segment_intersection.checked", ""); // all is up to date
    }
    ~OtherBuild() {
        fs::remove_all(folder);
        fs::remove(checked());
    }
    OtherBuild(const OtherBuild &) = delete;
    OtherBuild &operator=(const OtherBuild &) = delete;

    const fs::path folder = fs::temp_directory_path() / ("other build " + std::to_string(::getpid())),
                   work = folder / "loop";
};

/// A course whose only file of the student's is our answer to section 7.
struct OwnCourse {
    OwnCourse() {
        fs::create_directories(root / "exercises");
        course::link_all_but({"exercises", ".course", ".git"}, COURSE_ROOT, root);
        write(course::read_file(fs::path{COURSE_ROOT} / "solutions/07_segment_intersection.cpp"));
    }
    ~OwnCourse() { fs::remove_all(root); }
    OwnCourse(const OwnCourse &) = delete;
    OwnCourse &operator=(const OwnCourse &) = delete;

    void write(const std::string &text) const { course::write_file(file, text); }
    /// The function that begins so throws this at its start.
    void throw_in(const std::string &function, const std::string &what) const {
        std::string answer = course::read_file(file);
        const std::size_t begin = answer.find(function);
        REQUIRE(begin != answer.npos);
        write(answer.insert(answer.find("{\n", begin) + 2, "    throw " + what + ";\n"));
    }
    std::string operator()(const std::vector<std::string> &words) const {
        return course::run(course::course_command({root, build.folder}, words)).out;
    }
    std::string check(const std::string &what) const { return (*this)({"check", what}); }

    const OtherBuild build{""}; // whose pages are not told of it
    const fs::path root = fs::temp_directory_path() / ("a course of my own " + std::to_string(::getpid())),
                   file = root / "exercises/07_segment_intersection.cpp";
};

/// The same command, as an ordinary user types it.
std::vector<std::string> as_nobody(const std::vector<std::string> &command) {
    std::vector<std::string> line{"setpriv",        "--reuid=65534", "--regid=65534",
                                  "--clear-groups", "env",           "HOME=/nowhere"};
    line.insert(line.end(), command.begin(), command.end());
    return line;
}

/// What check says of a file, and what it leaves with.
std::string said_of(const course::Finished &done) { return done.out + done.err + "code " + std::to_string(done.code); }

#ifdef __linux__
/// What a command says and how it leaves, on a kernel that has no Landlock.
std::string said_without_landlock(const std::vector<std::string> &words) {
    std::vector<std::string> line{ATTACK};
    const auto command = course::course_command({COURSE_ROOT, COURSE_BUILD}, words);
    line.insert(line.end(), command.begin(), command.end());
    return said_of(course::run(line));
}
#endif

constexpr const char *our_answer = "solutions/07_segment_intersection.cpp";

/// Ways in which a file can have a compiler open another one, whose path stands in the place of @.
const std::vector<std::string> ways_to_open{
    "#include \"@\"\n",
    "#include \"@\"\n#include \"nowhere.hpp\"\n",
    "#define HERE <@>\n#include HERE\n",
    "#include \"../../../../../../../../../../../../..@\"\n",
    "#import \"@\"\n",
    "#include_next <@>\n",
    "#pragma GCC dependency \"@\"\n",
    "#line 1 \"@\"\nint wrong = ;\n",
    "# 1 \"@\" 1\nint wrong = ;\n",
    "asm(\".incbin \\\"@\\\"\");\n",
    "asm(\".include \\\"@\\\"\");\n",
};

} // namespace

TEST_CASE("asked for one exercise that is passed, check names the first that was open when it was last judged") {
    OwnCourse course;
    course.throw_in("\nBall move_and_bounce(", "course::NotYet{\"where does it begin?\"}");
    course.check("7");
    const std::string ball = "\nNext: 7.4 move_and_bounce. Where to begin: ./course hint 7.4\n";
    CHECK(course.check("7.2").ends_with(ball));
    CHECK(course.check("7.6").ends_with(ball));
    course.throw_in("\nbool segments_intersect(", "course::NotYet{\"where does it begin?\"}");
    course.check("7.2");
    CHECK(course.check("7.1").ends_with("\nNext: 7.2 segments_intersect. Where to begin: ./course hint 7.2\n"));
    CHECK(course.check("7.6").ends_with("\nNext: 7.2 segments_intersect. Where to begin: ./course hint 7.2\n"));
}

TEST_CASE("a compiler's error takes no tick away, and whoever passes the last exercise has passed the section") {
    OwnCourse course;
    const std::string all = "\nAll of section 7 passes. See your figures in the book: ./course open 7 --mine\n";
    course.throw_in("\nBall move_and_bounce(", "1");
    CHECK(course.check("7").ends_with("\nNext: 7.4 move_and_bounce. Stuck? ./course hint 7.4\n"));
    const std::string right = course::read_file(fs::path{COURSE_ROOT} / our_answer);
    for (const char *what : {"7", "7.4", "7.1"}) {
        CAPTURE(what);
        course.write(right + "\nint slip = ;\n");
        CHECK_THAT(course.check(what), ContainsSubstring("does not compile"));
        CHECK_THAT(course({"list"}), ContainsSubstring(": 5 of 6 passed"));
    }
    CHECK_THAT(course({"list"}), ContainsSubstring("Next: ./course check 7 (it does not compile)"));
    course.write(right);
    CHECK(course.check("7.4").ends_with(all));
    CHECK(course.check("7.1").ends_with(all));
    CHECK_THAT(course({"list"}), ContainsSubstring(": 6 of 6 passed"));
}

TEST_CASE("an exercise that was never tried isn't called stuck because another one does not compile") {
    OwnCourse course;
    course.write("int slip = ;\n" + course::read_file(fs::path{COURSE_ROOT} / our_answer));
    course.check("7.1");
    course.write(course::read_file(fs::path{COURSE_ROOT} / our_answer));
    CHECK(course.check("7.1").ends_with("\nNext: 7.2 segments_intersect. Where to begin: ./course hint 7.2\n"));
}

TEST_CASE("what is saved while a check runs was not judged, and list says that the file has changed since") {
    OwnCourse course;
    fs::remove(course.build.folder / "tests");
    const fs::path tests = course.build.folder / "tests/07_segment_intersection";
    course::write_file(tests, "#!/bin/sh\necho '// saved meanwhile' >> '" + course.file.string() + "'\nexec '"
                                  + (fs::path{COURSE_BUILD} / "tests/07_segment_intersection").string() + "' \"$@\"\n");
    fs::permissions(tests, fs::perms::all);
    CHECK_THAT(course.check("7"), ContainsSubstring("All of section 7 passes."));
    CHECK_THAT(course({"list"}), ContainsSubstring("07_segment_intersection.cpp has changed since the last check"));
}

TEST_CASE("asked for one exercise, check runs no other's tests: an endless loop in another one takes no time") {
    const auto one = check("7.2", "tests/verdicts/endless_loop.cpp"); // which is in 7.1
    CHECK(one.out.starts_with("· 7.2 segments_intersect, core: not started\n"));
    CHECK(count(one.out, "7.1") == 0);
    const fs::path built = COURSE_BUILD;
    const auto said =
        course::run({(built / "tests/07_segment_intersection").string(),
                     (built / "subjects/07_segment_intersection/stub").string(), "--json", "--exercise", "7.2"});
    CHECK(count(said.out, "\"exercise\":\"7.2\"") == count(said.out, "\n"));
    CHECK(count(said.out, "\n") > 0);
}

TEST_CASE("asked for one exercise, check speaks of no other that is passed, and leaves with its verdict") {
    const auto done = check("7.2", our_answer);
    CHECK(done.out.starts_with("✓ 7.2 segments_intersect, core: "));
    CHECK(done.out.ends_with(" tests passed\nThe whole section: ./course check 7\n"));
    CHECK(count(done.out, "\n") == 2);
    CHECK(done.code == 0);

    const auto not_begun = check("7.2", "tests/07_segment_intersection/stub.cpp");
    CHECK(not_begun.out
          == "· 7.2 segments_intersect, core: not started\nNext: 7.2 segments_intersect. Where to begin: ./course hint "
             "7.2\n");
    CHECK(not_begun.code == 1);

    CHECK(count(check("7.1", "tests/verdicts/warnings.cpp").out, "warning ") == 2);
    CHECK(count(check("7.2", "tests/verdicts/warnings.cpp").out, "warning ") == 0);

    const auto other = check("7.2", "tests/verdicts/wrong_answer.cpp"); // of 7.1
    CHECK(count(other.out, "7.1") == 0);
    CHECK(check("7.9", our_answer).code == 2);
}

TEST_CASE("check says which known mistake gives the same, unless it's told not to") {
    const std::string known = "This is what comes out when you ";
    CHECK(count(check("7.1", "tests/verdicts/wrong_answer.cpp").out, known) == 1);
    const auto silent = course::run(
        course::course_command({COURSE_ROOT, COURSE_BUILD}, {"check", "7.1", "--no-diagnosis", "--file",
                                                             COURSE_ROOT "/tests/verdicts/wrong_answer.cpp"}));
    CHECK(silent.code == 1);
    CHECK(count(silent.out, known) == 0);
}

TEST_CASE("a failure with something to see is drawn on a page, and others are said to have nothing") {
    const auto drawn = [](const std::string &exercise) {
        auto command = check_command(exercise, "tests/verdicts/nothing.cpp", COURSE_BUILD);
        command.push_back("--picture");
        return course::run(command);
    };
    const course::Finished seen = drawn("7.1");
    CHECK(seen.code == 1);
    const fs::path page = fs::path{COURSE_BUILD} / "picture.html";
    CHECK_THAT(seen.out, ContainsSubstring("file://" + page.string()));
    CHECK_THAT(course::read_file(page), ContainsSubstring("7.1 <code>intersect_lines</code>"));
    CHECK_THAT(course::read_file(page), ContainsSubstring("class=\"expected"));
    CHECK_THAT(drawn("7.2").out, ContainsSubstring("nothing to draw"));
    fs::remove(checked());
}

TEST_CASE("a file that isn't the student's is neither read nor told of while his is compiled, whoever runs the check") {
    if (!course::protection_of_this_kernel().files) SKIP("this kernel has no Landlock");
    REQUIRE(check("7.2", our_answer).code == 0); // and all of section 7 is built
    const OtherBuild build{""};
    const course::OwnFolder own;
    fs::permissions(own.path, fs::perms::all);
    const fs::path answer = own.path / "ann.cpp", roster = own.path / "roster.csv";
    const bool by_root = ::geteuid() == 0 && course::run(as_nobody({"cat", COURSE_BUILD "/course.json"})).code == 0;
    if (by_root)
        for (const fs::path &its : {build.folder, build.work, build.work / "07_segment_intersection.checked"})
            REQUIRE(::chown(its.c_str(), 65534, 65534) == 0);
    const auto line = course::course_command({COURSE_ROOT, build.folder}, {"check", "7.2", "--file", answer.string()});
    for (const bool as_user : {false, true})
        for (std::string way : ways_to_open) {
            if (as_user && !by_root) continue;
            CAPTURE(as_user, way);
            course::replace_all(way, "@", roster.string());
            course::write_file(answer, course::read_file(fs::path{COURSE_ROOT} / our_answer) + way);
            course::write_file(roster, "xyzzy = Ann Other, 4711;\n");
            const std::string there = said_of(course::run(as_user ? as_nobody(line) : line));
            fs::remove(roster);
            const std::string not_there = said_of(course::run(as_user ? as_nobody(line) : line));
            CHECK(there == not_there);
            CHECK(there.ends_with("code 1"));
            CHECK(count(there, "does not compile") == 1);
            CHECK(count(there, "xyzzy") == 0);
        }
    if (!by_root) return;
    course::write_file(answer, course::read_file(fs::path{COURSE_ROOT} / our_answer));
    CHECK(said_of(course::run(as_nobody(line))).ends_with("code 0"));
}

#ifdef __linux__
TEST_CASE("a kernel without Landlock is told of before others' code is judged there, and not of one's own") {
    const course::Protection here = course::protection_of_this_kernel();
    if (!here.files || !here.calls) SKIP("this kernel lacks one of the two anyway, or a sanitizer is in the way");
    const course::OwnFolder own;
    const fs::path answer = own.path / "1001/07_segment_intersection.cpp";
    fs::create_directory(answer.parent_path());
    fs::copy_file(fs::path{COURSE_ROOT} / our_answer, answer);
    const std::string warning = "This kernel lacks Landlock, so code isn't shut in: judge only what you trust.";
    CHECK(count(said_without_landlock({"check", "7.2", "--file", answer.string()}), warning) == 1);
    CHECK(count(said_without_landlock({"check", "7.2"}), warning) == 0);
    CHECK(said_without_landlock({"grade", "7", own.path.string(), "--dry-run"}).starts_with(warning));
    CHECK_THAT(said_without_landlock({"doctor"}), ContainsSubstring("Landlock        not in this kernel: "));
    CHECK(count(check("7.2", our_answer).err, "lacks") == 0);
}
#endif

TEST_CASE("a compiler doesn't wait for what it says itself, which it'd do for ever if check were killed") {
    if (!course::protection_of_this_kernel().files) SKIP("this kernel has no Landlock");
    const course::OwnFolder own;
    const fs::path answer = own.path / "ann.cpp";
    for (const std::string end : {"1", "2"}) {
        course::write_file(answer, course::read_file(fs::path{COURSE_ROOT} / our_answer)
                                       + "#warning hello\n#include \"/proc/self/fd/" + end + "\"\n");
        const std::string said = said_of(check({"7", "--file", answer.string()}));
        CHECK_THAT(said, ContainsSubstring("A check can't open this file"));
    }
}

TEST_CASE("on a kernel without Landlock, too, a file may include nothing but headers, and isn't waited for") {
#ifdef __linux__
    const course::OwnFolder own;
    const fs::path answer = own.path / "ann.cpp", other = own.path / "other";
    const std::string ours = course::read_file(fs::path{COURSE_ROOT} / our_answer);
    const auto checked_with = [&](const std::string &more) {
        course::write_file(answer, ours + more);
        return said_without_landlock({"check", "7.2", "--file", answer.string()});
    };
    CHECK(checked_with("").ends_with("code 0"));
    course::write_file(other, "xyzzy = 1;\n");
    const std::string include = "#include \"" + other.string() + "\"\n", there = checked_with(include);
    CHECK_THAT(there, ContainsSubstring("A check can't open this file"));
    fs::remove(other);
    CHECK(checked_with(include) == there);
    ::mkfifo(other.c_str(), 0600);
    const auto begin = std::chrono::steady_clock::now();
    CHECK_THAT(checked_with(include), ContainsSubstring("The compiler waited for something that never came"));
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds{18});
#else
    SKIP("there is none here");
#endif
}

TEST_CASE("what a shell sets for compilers, or doesn't, changes nothing; a limit of its own for files is said") {
    const std::vector<std::string> line{"sh", "-c", "set=$1; shift; eval \"$set\"; exec \"$@\"", "sh", ""};
    const auto in_shell = [&](const std::string &setting) {
        std::vector<std::string> all = line;
        all.back() = setting;
        for (const auto &word : check_command("7.2", our_answer, COURSE_BUILD)) all.push_back(word);
        return course::run(all);
    };
    const course::OwnFolder own;
    course::write_file(own.path / "cmath", "#error the wrong one\n");
    for (const std::string setting :
         {"unset PATH; exec /usr/bin/\"$@\"", "PATH=/nowhere; exec /usr/bin/\"$@\"",
          "export GCC_EXEC_PREFIX=/nowhere/ COMPILER_PATH=/nowhere",
          "export CPATH='FOLDER' CPLUS_INCLUDE_PATH='FOLDER'", "export LIBRARY_PATH='FOLDER' TMPDIR=/nowhere"}) {
        std::string set = setting;
        course::replace_all(set, "FOLDER", own.path.string());
        CAPTURE(set);
        CHECK(in_shell(set).code == 0);
    }
    const auto small = in_shell("ulimit -f 100");
    CHECK(small.code == 4);
    CHECK_THAT(small.err, ContainsSubstring("lets no file grow beyond") && ContainsSubstring("ulimit -f unlimited"));
    fs::remove(checked());
}

/// A section 7 whose built files are there, by their names.
void pretend_to_build(const course::SmallCourse &small) {
    const fs::path build = small.workspace.build;
    const auto file = [&](const char *name) { return (build / name).string(); };
    const nlohmann::json section{{"name", "07_wall_meeting"},
                                 {"server", file("server.o")},
                                 {"missing", file("missing.o")},
                                 {"ours", file("ours.o")},
                                 {"earlier", nlohmann::json::array()}};
    const nlohmann::json none = nlohmann::json::array();
    small.write(build / "course.json", nlohmann::json{{"compiler", "c++"},
                                                      {"flags", none},
                                                      {"precompiled", none},
                                                      {"nm", "nm"},
                                                      {"objcopy", "objcopy"},
                                                      {"node", ""},
                                                      {"link", none},
                                                      {"includes", none},
                                                      {"sections", {section}}}
                                           .dump());
    for (const char *name : {"server.o", "missing.o", "ours.o", "tests/07_wall_meeting"})
        small.write(build / name, "whole");
    small.write("exercises/07_wall_meeting.cpp", "int first() { return 1; }\n");
    small.write(build / "loop/07_wall_meeting.checked", "");
}

TEST_CASE("of a course that's set up and not built, the one section that's checked is built, and no other") {
    const course::SmallCourse small;
    pretend_to_build(small);
    const fs::path catalogue = small.workspace.catalogue(small.seven()), aside = small.workspace.root / "aside";
    fs::rename(catalogue, aside);
    const auto path = small.instead_of("cmake", "echo \"$@\" >> '" + (small.workspace.root / "asked").string()
                                                    + "'\ncp '" + aside.string() + "' '" + catalogue.string() + "'");
    CHECK_THAT(small({"check", "7.1"}, {path}).err,
               ContainsSubstring("Section 7 isn't built yet, which takes a minute, this once\n"));
    CHECK(small.read("asked") == "--build " + small.workspace.build.string() + " --target 07_wall_meeting_loop\n");
    CHECK_THAT(small({"check", "7.1"}, {path}).err, !ContainsSubstring("isn't built yet"));
}

TEST_CASE("what was built and has been cut to nothing is built again, not believed") {
    const course::SmallCourse small;
    const fs::path build = small.workspace.build, program = build / "tests/07_wall_meeting";
    pretend_to_build(small);
    small.write(program, "");
    const auto path = small.instead_of("cmake", "exit 1");
    const auto done = small({"check", "7"}, {path});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, ContainsSubstring("the course's own files don't build"));
    CHECK_FALSE(fs::exists(program)); // what makes ninja build it
    CHECK(fs::exists(build / "server.o"));
}

TEST_CASE("a mended test is built whatever its date says, and whatever the clock said when others were") {
    const course::SmallCourse small;
    pretend_to_build(small);
    const fs::path tests = small.workspace.tests(small.seven()),
                   stamp = small.workspace.build / "loop/07_wall_meeting.checked",
                   asked = small.workspace.root / "asked";
    const auto path = small.instead_of("cmake", "echo \"$@\" >>'" + asked.string() + "'");
    const auto asks = [&] { // of the build, and its words
        fs::remove(asked);
        small({"check", "7"}, {path});
        return fs::exists(asked) ? course::read_file(asked) : "";
    };
    const auto now = fs::file_time_type::clock::now();
    small.write(tests, "one");
    CHECK(count(asks(), "--target 07_wall_meeting_loop") == 1); // it's newer
    CHECK(asks() == "");
    const auto date = fs::last_write_time(tests);
    small.write(tests, "two");
    fs::last_write_time(tests, date);
    CHECK(count(asks(), "--target 07_wall_meeting_loop") == 1);
    CHECK(fs::last_write_time(tests) > date); // what makes ninja build it
    CHECK(asks() == "");
    for (const char *included : {"tests/dice.hpp", "tools/base/text.hpp"}) {
        small.write(included, "// three");
        CHECK(count(asks(), "--target 07_wall_meeting_loop") == 1);
    }
    std::string record = course::read_file(stamp);
    const std::size_t dice = record.find(" tests/dice.hpp\n"), line = record.rfind('\n', dice) + 1;
    record.erase(line, record.find('\n', dice) + 1 - line);
    const auto when = fs::last_write_time(stamp);
    course::write_file(stamp, record);
    fs::last_write_time(stamp, when);
    CHECK(asks() == ""); // the record of a course that didn't look at all of them
    for (const fs::path &ahead : {stamp, small.workspace.build / "tests/07_wall_meeting"}) {
        fs::last_write_time(ahead, now + std::chrono::hours{24});
        CHECK(count(asks(), "-- -t clean 07_wall_meeting_loop") == 1); // nor is a date of what it makes believed
        fs::last_write_time(ahead, now);
    }
    asks();
    const course::OwnFolder other;
    const fs::path elsewhere = other.path / "course";
    fs::create_directory_symlink(small.workspace.root, elsewhere);
    const auto touched = fs::last_write_time(tests);
    course::run(course::course_command({elsewhere, small.workspace.build}, {"check", "7"}, {path}));
    CHECK(fs::last_write_time(tests) == touched); // the same course by another path is no other one
}

TEST_CASE("a compiler that the machine has stopped is no verdict, and exits with 4") {
    REQUIRE(check("7.1", our_answer).code == 0); // and all of section 7 is built
    const auto [script, sentence] = GENERATE(table<std::string, std::string>({
        {"kill -KILL $$", "the compiler was killed from outside"},
        {"echo 'as: x.o: No space left on device' >&2; exit 1", "the compiler found the disk full"},
    }));
    const OtherBuild build{script};
    const auto done = course::run(check_command("7.1", our_answer, build.folder));
    CHECK(done.code == 4);
    CHECK(done.out.empty());
    CHECK_THAT(done.err, ContainsSubstring(sentence));
}

TEST_CASE("an answer with nothing to complain of is compiled by Clang, where it is there, and any other one by GCC") {
    REQUIRE(check("7.1", our_answer).code == 0);
    const auto settings = nlohmann::json::parse(course::read_file(COURSE_BUILD "/course.json"));
    if (!settings.contains("quick")) SKIP("there is one compiler only");
    const OtherBuild build{"case \"$*\" in *' -c '*) echo \"$PWD/student.cpp:1:1: warning: by GCC\" >&2; esac; exec '"
                           + settings.at("compiler").get<std::string>() + "' \"$@\""}; // it always links
    const fs::path answer = build.folder / "answer.cpp";
    const std::string ours = course::read_file(fs::path{COURSE_ROOT} / our_answer);
    const auto gcc_compiles = [&](const std::string &added) {
        course::write_file(answer, ours + added);
        const auto done = check({"7", "--file", answer.string()}, build.folder);
        CHECK_THAT(done.out, ContainsSubstring("✓ 7.2"));
        return count(done.out, "by GCC");
    };
    CHECK(gcc_compiles("") == 0);
    CHECK(gcc_compiles("static int unused = 0;\n") == 1);
    CHECK(gcc_compiles("int odd(int n) { switch (n % 2) { case 0: return 0; default: return 1; } }\n") == 1);

    auto broken = nlohmann::json::parse(course::read_file(build.folder / "course.json"));
    broken["quick"]["compiler"] = "false";
    course::write_file(build.folder / "course.json", broken.dump());
    CHECK(gcc_compiles("") == 1);
}

TEST_CASE("what is never reached is told of a file that does not link, too") {
    const course::OwnFolder own;
    const fs::path answer = own.path / "answer.cpp";
    course::write_file(answer, course::read_file(fs::path{COURSE_ROOT} / our_answer)
                                   + "double nowhere();\ndouble half() {\n    return nowhere();\n    nowhere();\n}\n");
    const auto done = check({"7", "--file", answer.string()});
    CHECK_THAT(done.out, ContainsSubstring("does not link") && ContainsSubstring("is never reached: move it up"));
}

TEST_CASE("what a compiler says when it gives up names the student's file, and not where it was compiled") {
    const course::OwnFolder own;
    const fs::path answer = own.path / "answer.cpp";
    std::string text;
    for (int i = 0; i < 80'000; ++i) text += "namespace a{"; // after which it gives up
    course::write_file(answer, text + '\n' + course::read_file(fs::path{COURSE_ROOT} / our_answer));
    const auto done = check({"7", "--file", answer.string()});
    CHECK_THAT(done.out, ContainsSubstring(answer.string() + ":1:")); // GCC calls it no error, and Clang does
    CHECK_THAT(done.out, !ContainsSubstring(COURSE_BUILD));
}

TEST_CASE("a disk that is full is no verdict, and check exits with 4") {
    REQUIRE(check("7.1", our_answer).code == 0);
    const OtherBuild build{""};
    if (course::run({"unshare", "--mount", "mount", "-t", "tmpfs", "none", build.work.string()}).code != 0)
        SKIP("only root may mount a small disk here");
    std::vector<std::string> line{"unshare",
                                  "--mount",
                                  "sh",
                                  "-c",
                                  "mount -t tmpfs -o size=\"$1\" none \"$2\" && "
                                  "touch \"$2/07_segment_intersection.checked\" && shift 2 && exec \"$@\"",
                                  "sh",
                                  "",
                                  build.work.string()};
    for (const std::string &word : check_command("7.1", our_answer, build.folder)) line.push_back(word);
    line[6] = "64M";
    CHECK(course::run(line).code == 0);
    line[6] = "64k";
    const auto done = course::run(line);
    CHECK(done.code == 4);
    CHECK(done.out.empty());
    CHECK_THAT(done.err, ContainsSubstring("disk full") || ContainsSubstring("less full"));
}

TEST_CASE("a section that builds on another one has its own exercises only") {
    const std::string checked = check("11", "tests/11_particles/stub.cpp").out;
    CHECK(count(checked, ": not started\n") == 10);
    CHECK(count(checked, " 7.") == 0);
}

TEST_CASE("a section's program prints one part alone, and lists its parts for a name that it does not know") {
    const std::string program = COURSE_BUILD "/chapters/02_momentum";
    const auto whole = course::run({program, "--out", fs::temp_directory_path().string()});
    const auto part = course::run({program, "pulled"});
    CHECK(part.code == 0);
    CHECK(part.out.starts_with("t [s]  2 kg "));
    CHECK(whole.out.starts_with(part.out + "\nt [s]  v_a "));

    const auto unknown = course::run({program, "puled"});
    CHECK(unknown.code == 2);
    CHECK(unknown.out.empty());
    CHECK(unknown.err
          == "this program has no part `puled`; its parts are pulled, meeting, materials, frames, clicks, cradle\n");
    CHECK(course::run({program, "pulled", "meeting"}).code == 2);
}

TEST_CASE("check --file takes a file of any name, and says what is wrong with one that it cannot read as text") {
    const course::OwnFolder own;
    const fs::path &folder = own.path;
    const auto said = [](const fs::path &file) {
        const auto done = check({"7.2", "--file", file.string()});
        return done.out + done.err + "code " + std::to_string(done.code);
    };
    const fs::path solution = fs::path{COURSE_ROOT} / "solutions/07_segment_intersection.cpp";
    for (const char *any :
         {"ann.txt", "ann", "ann.hpp", "ann.o", "-ann.cpp", "an answer, 'finished' for $5.cxx", "two\nlines.cpp"}) {
        CAPTURE(any);
        fs::copy(solution, folder / any);
        CHECK(said(folder / any).ends_with("code 0"));
    }
    CHECK(said(folder) == "course: " + folder.string() + " is a folder, not a file with answers\ncode 2");
    CHECK(said("/dev/zero") == "course: /dev/zero is a device, not a file with answers\ncode 2");
    ::mkfifo((folder / "pipe").c_str(), 0600);
    CHECK(said(folder / "pipe").ends_with("pipe is a pipe, not a file with answers\ncode 2"));
    course::write_file(folder / "large.cpp", course::read_file(solution) + std::string(1'000'000, '\n'));
    CHECK(said(folder / "large.cpp").find("KB, too much for a file with answers: at most 1000 are read\ncode 2")
          != std::string::npos);
    fs::resize_file(folder / "large.cpp", 1'000'000);
    CHECK(said(folder / "large.cpp").ends_with("code 0"));
    CHECK(said(folder / "none.cpp").ends_with("does it exist, and may you read it?\ncode 2"));
}

TEST_CASE("a file name or an argument can't send escape codes to the terminal") {
    const course::OwnFolder own;
    const fs::path file = own.path / "\x1b[2K\xe2\x9c\x93 all passed.cpp";
    course::write_file(file, "int main( {\n");
    const auto unbuilt = check({"7", "--file", file.string()}), missing = check({"7", "--file", "\x1b[2Knone.cpp"}),
               unknown = check({"\x1b[2Kseven"});
    CHECK(unbuilt.code == 1);
    for (const auto &said : {unbuilt, missing, unknown}) {
        CAPTURE(said.out, said.err);
        CHECK((said.out + said.err).find("?[2K") != std::string::npos);
        CHECK((said.out + said.err).find('\x1b') == std::string::npos);
    }
}

TEST_CASE("an option or a section that is empty is an error, not one that was not given") {
    const std::vector<std::string> words =
        GENERATE(std::vector<std::string>{"7", "--file", ""}, std::vector<std::string>{"7", "--file="},
                 std::vector<std::string>{"7", "--junit", ""}, std::vector<std::string>{""});
    const auto done = check(words);
    CAPTURE(words, done.err);
    CHECK(done.code == 2);
    CHECK(done.out.empty());
    CHECK(count(done.err, "see ./course check --help\n") == 1);
    CHECK(count(done.err, "\n") == 1);
}

TEST_CASE("a seed is a whole number, and check says so of anything else") {
    for (const char *seed : {"-1", "1.5", "abc", "99999999999"}) {
        const auto done = check({"7", "--seed", seed});
        CHECK(done.code == 2);
        CHECK(done.err
              == "course: --seed: a whole number of up to nine digits is wanted, not " + std::string{seed}
                     + "; see ./course check --help\n");
    }
}

TEST_CASE(
    "an earlier JUnit file is removed before anything is judged; a place that cannot be written is an error then") {
    const course::OwnFolder own;
    const fs::path &folder = own.path;
    const auto check_into = [](const fs::path &junit, const std::string &file) {
        return check({"7.2", "--file", COURSE_ROOT "/" + file, "--junit", junit.string()});
    };
    course::write_file(folder / "old.xml", "<?xml version=\"1.0\"?>\n<testsuites />\n");
    CHECK(check_into(folder / "old.xml", "not/there.cpp").code == 2);
    CHECK(fs::is_empty(folder));

    course::write_file(folder / "a file", "");
    for (const char *where : {"a file/new.xml", "nowhere/new.xml"}) {
        const auto nowhere = check_into(folder / where, "solutions/07_segment_intersection.cpp");
        CHECK(nowhere.code == 2);
        CHECK(nowhere.out.empty());
        CHECK(count(nowhere.err, "there's no folder " + (folder / where).parent_path().string()) == 1);
    }
    CHECK_FALSE(fs::exists(folder / "nowhere"));
    CHECK(check_into(folder, "solutions/07_segment_intersection.cpp").err
          == "course: --junit writes a file, and " + folder.string() + " is something else\n");

    CHECK(check_into(folder / "new.xml", "solutions/07_segment_intersection.cpp").code == 0);
    CHECK(course::read_file(folder / "new.xml").starts_with("<?xml"));
}

TEST_CASE("a check sweeps folders that a kill left over an hour ago, and no younger ones") {
    const fs::path loop = fs::path{COURSE_BUILD} / "loop", old = loop / "judge.tstold", young = loop / "judge.tstnew";
    for (const fs::path &left : {old, young}) course::write_file(left / "student.o", "half");
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours{2});
    CHECK(check({"7", "--file", COURSE_ROOT "/solutions/07_segment_intersection.cpp"}).code == 0);
    CHECK_FALSE(fs::exists(old));
    CHECK(fs::exists(young));
    fs::remove_all(young);
}

TEST_CASE("a JUnit file takes the place of an empty file or an earlier report, and of no other file") {
    const course::OwnFolder own;
    const fs::path file = own.path / "mine.cpp";
    const auto check_into_itself = [&](const std::string &text) {
        course::write_file(file, text);
        return check({"7.2", "--file", COURSE_ROOT "/tests/verdicts/empty.cpp", "--junit", file.string()});
    };
    for (const std::string text : {"// all of my work\n", "x", "<?xm"}) {
        const auto done = check_into_itself(text);
        CHECK(done.code == 2);
        CHECK(done.out.empty());
        CHECK(done.err
              == "course: --junit would overwrite " + file.string()
                     + ", which is not an earlier report: give it another name, or delete that file first\n");
        CHECK(course::read_file(file) == text);
    }
    for (const char *text : {"", "<?xml version=\"1.0\"?>\n"}) {
        CHECK(check_into_itself(text).code == 1);
        CHECK(course::read_file(file).starts_with("<?xml"));
    }
}

TEST_CASE("check all says of a file that is missing that it is, and judges and reports the other sections") {
    const course::SmallCourse small;
    const auto list = [](const std::string &number) {
        return R"({"exercises": [{"number": ")" + number + R"(", "tier": "core", "function": "first"}], "tests": )"
               + R"([{"exercise": ")" + number + R"(", "claim": "one"}, {"exercise": ")" + number
               + R"(", "claim": "two"}]})";
    };
    small.write(small.workspace.build / "catalogue/06_reflection.json", list("6.1"));
    small.write(small.workspace.build / "catalogue/07_wall_meeting.json", list("7.1"));
    small.write("exercises/07_wall_meeting.cpp", "\n");
    const fs::path report = small.workspace.root / "all.xml";
    const auto check_all = [&] { return small({"check", "all", "--junit", report.string()}, {"NO_COLOR=1"}); };

    fs::remove(small.workspace.root / "exercises/06_reflection.cpp");
    const auto missing = check_all();
    CHECK(missing.code == 2);
    const std::string sentence =
        "exercises/06_reflection.cpp is not there; `./course reset 6` brings the empty one back.";
    CHECK(missing.out.starts_with("✗ " + sentence + "\n\n✗ exercises/07_wall_meeting.cpp is empty\n"));
    const std::string xml = course::read_file(report);
    CHECK(count(xml, "<testcase ") == 4);
    CHECK(count(xml, "message=\"" + sentence) == 2);
    CHECK(count(xml, "message=\"exercises/07_wall_meeting.cpp is empty.") == 2);
    CHECK(count(xml, "<testsuite name=\"06_reflection\" tests=\"2\" failures=\"2\"") == 1);

    fs::create_directory(small.workspace.root / "exercises/06_reflection.cpp");
    const auto folder = check_all();
    CHECK(folder.code == 2);
    CHECK(count(folder.out, "is a folder, not a file with answers\n") == 1);
    CHECK(count(course::read_file(report), "<testcase ") == 4);
}

TEST_CASE("watching judges at once, at each save and at Enter, and q leaves") {
    const course::OwnFolder own;
    const fs::path &folder = own.path;
    const fs::path file = folder / "mine.cpp";
    fs::copy(fs::path{COURSE_ROOT} / "tests/verdicts/syntax_error.cpp", file); // judged by the compiler alone: quick

    // Keys at 3 s and 9 s, a save at 6 s; each judgement takes less than one.
    const std::string script =
        "(sleep 3; echo; sleep 3; echo '// more' >>\"$1\"; sleep 3; echo q) | "
        "env COURSE_ROOT='" COURSE_ROOT "' COURSE_BUILD='" COURSE_BUILD "' \"$2\" --watch check 7 --file \"$1\"";
    const auto watched = course::run({"sh", "-c", script, "sh", file.string(), COURSE_TOOL}, {.deadline = 60});
    CHECK(watched.code == 0);
    CHECK(count(watched.out, "does not compile") == 3);
    CHECK(count(watched.out, "Waiting for you to save.") == 3);
}
