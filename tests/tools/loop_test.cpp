// The student's loop around the verdict: list, hint, solution, reset, run, debug; what is remembered; bad input.

#include "small_course.hpp"

#include "base/errors.hpp"
#include "base/lock.hpp"
#include "base/nearest.hpp"
#include "remember_now.hpp"
#include "site/progress_script.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <thread>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Matches;
using Catch::Matchers::Message;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;
using namespace course;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// Runs a command on a terminal of its own, types what is given once something stands there, and returns all of it.
Finished on_terminal(const std::vector<std::string> &command, const std::string &typed) {
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) become(command);
    Finished finished;
    char part[4096];
    std::string left = typed;
    for (ssize_t count; (count = ::read(terminal, part, sizeof part)) > 0;) { // EIO at its end, on Linux
        finished.out.append(part, static_cast<std::size_t>(count));
        if (!left.empty()) left.erase(0, static_cast<std::size_t>(::write(terminal, left.data(), left.size())));
    }
    ::close(terminal);
    int status = 0;
    ::waitpid(child, &status, 0);
    finished.code = WEXITSTATUS(status);
    return finished;
}

/// Starts a command, sends it a signal as soon as `ready` holds, and returns its exit code.
template <class Ready> int stopped(const std::vector<std::string> &command, int signal, Ready ready) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::setpgid(0, 0);
        const int nowhere = ::open("/dev/null", O_RDWR);
        for (int stream : {0, 1, 2}) ::dup2(nowhere, stream);
        become(command);
    }
    for (int tries = 0; tries < 500 && !ready(); ++tries) std::this_thread::sleep_for(10ms);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool alive(const std::string &process) { return ::kill(std::stoi(process), 0) == 0; }

bool ends_soon(const std::string &process) {
    for (int tries = 0; tries < 200; ++tries, std::this_thread::sleep_for(10ms)) {
        if (!alive(process)) return true;
        std::ifstream status{"/proc/" + process + "/stat"}; // a container without an init keeps the dead
        const std::string text{std::istreambuf_iterator<char>{status}, {}};
        if (text.find(") Z ") != std::string::npos) return true;
    }
    return false;
}

int kilobytes(const std::string &text) { return static_cast<int>(text.size() / 1024); }

} // namespace

// ---- Words that are nearly right

TEST_CASE("the distance of two words counts letters put in, left out, changed and swapped") {
    CHECK(edit_distance("check", "check") == 0);
    CHECK(edit_distance("chek", "check") == 1);
    CHECK(edit_distance("checkk", "check") == 1);
    CHECK(edit_distance("cheek", "check") == 1);
    CHECK(edit_distance("chekc", "check") == 1);
    CHECK(edit_distance("", "list") == 4);
    CHECK(edit_distance("lsit", "hint") == 3);
}

TEST_CASE("the nearest word is offered, or none if no word is similar") {
    CHECK(nearest("LSIT", {"hint", "list", "plot"}) == "list");
    CHECK(nearest("xyz", {"hint", "list"}).empty());
    CHECK(nearest("list", {}).empty());
    CHECK(did_you_mean("lsit", {"hint", "list"}) == " Did you mean `list`?");
    CHECK(did_you_mean("xyz", {"hint"}).empty());
}

TEST_CASE("a section is named by its number, its name, a part of it, an exercise, or a file") {
    const SmallCourse course;
    const std::string words =
        GENERATE("7", "07", "7.2", "07_wall_meeting", "wall_meeting", "Wall meeting", "wall-meeting", "meet", "WALL",
                 "exercises/07_wall_meeting.cpp", "./chapters/07_wall_meeting/README.md", "chapters/07_wall_meeting/",
                 "/elsewhere/07_wall_meeting.cpp", "plots/07_wall_meeting_path.gp", "07_wall_meeting.cpp");
    CAPTURE(words);
    CHECK(course.workspace.section(words).name == "07_wall_meeting");
}

TEST_CASE("an unknown section offers the nearest, an ambiguous one all that it may be") {
    const SmallCourse course;
    const auto [words, offer] = GENERATE(table<std::string, std::string>({
        {"wal_meeting", "Did you mean `07_wall_meeting`?"},
        {"reflexion", "Did you mean `06_reflection`?"},
        {"mteeing", "Did you mean `07_wall_meeting`?"},
        {"12", "Did you mean `07_wall_meeting`?"},
        {"1", "Did you mean `06_reflection`?"},
        {"12.3", "Did you mean `07_wall_meeting`?"},
        {std::string(300'000, '7'), "there is no section"},
        {"exercises/08_wall_meeting.cpp", "Did you mean `07_wall_meeting`?"},
        {"e", "may be 06_reflection or 07_wall_meeting"},
        {"", "./course list"},
        {"qqq", "./course list"},
    }));
    CAPTURE(words);
    CHECK_THROWS_MATCHES(course.workspace.section(words), UserError, MessageMatches(ContainsSubstring(offer)));
}

TEST_CASE("a line of CMakeLists.txt that only looks like a section is ignored") {
    const SmallCourse course;
    course.write("CMakeLists.txt",
                 "# section(01_motion)\nfunction(section name)\n  section( 07_wall_meeting )\r\nsection(7_x)\n"
                 "section(11_sparks BUILDS_ON 07_wall_meeting)\nsection(12_a-b)\n");
    REQUIRE(course.workspace.sections().size() == 2);
    CHECK(course.workspace.sections()[0].name == "07_wall_meeting");
    CHECK(course.workspace.sections()[1].name == "11_sparks");
}

TEST_CASE("a slip of the pen is answered in one sentence with the nearest word, and exit code 2") {
    const SmallCourse course;
    const auto [words, offer] = GENERATE(table<std::vector<std::string>, std::string>({
        {{"lsit"}, "there is no command `lsit`. Did you mean `list`? See ./course --help"},
        {{"lsit", "--help"}, "there is no command `lsit`. Did you mean `list`? See ./course --help"},
        {{"tets"}, "Did you mean `test`?"},
        {{"run", "7", "--mnie"}, "`run` has no option `--mnie`. Did you mean `--mine`? See ./course run --help"},
        {{"--hepl"}, "`course` has no option `--hepl`. Did you mean `--help`?"},
        {{"reset", "7", "8"}, "`reset` does not know what to do with `8`"},
        {{"reset", "7", "list"}, "`reset` does not know what to do with `list`"},
        {{"run"}, "section is required; see ./course run --help"},
        {{"run", "reflexion"}, "Did you mean `06_reflection`?"},
        {{"hint", "7.9"}, "there's no exercise 7.9; section 7 has 7.1, 7.2"},
        {{"hint", "7"}, "which exercise of section 7? It has 7.1, 7.2"},
        {{"hint", "secnod"}, "there's no exercise `secnod`. Did you mean `second`?"},
        {{"solution", "9.1"}, "there is no section `9.1`"},
        {{"run", "8"}, "section 8, n–t collisions, is still to come"},
        {{"check", "08.1"}, "section 8, n–t collisions, is still to come"},
        {{"reset", "7.2"}, "brings back a whole section"},
        {{"setup"}, "type ./course setup"},
        {{"weave", "--check"}, "`weave` is a command for authors: type ./course dev weave"},
        {{"bench", "--help"}, "`bench` is a command for authors: type ./course dev bench"},
        {{"dev", "waeve", "--help"}, "there is no command `waeve`. Did you mean `weave`? See ./course dev --help"},
        {{"dev", "weave", "--chekc"},
         "`weave` has no option `--chekc`. Did you mean `--check`? See ./course dev weave"},
    }));
    const Finished said = course(words);
    CAPTURE(said.err);
    CHECK(said.code == 2);
    CHECK(said.out.empty());
    CHECK_THAT(said.err, StartsWith("course: ") && ContainsSubstring(offer));
    CHECK(std::count(said.err.begin(), said.err.end(), '\n') == 1);
}

/// Whether the program lists the command, and the command's own help has an example.
void check_help(const SmallCourse &course, const std::string &list, std::vector<std::string> words) {
    CAPTURE(words);
    std::string example = "Example: ./course";
    for (const std::string &word : words) example += ' ' + word;
    CHECK_THAT(list, ContainsSubstring("\n  " + words.back() + " "));
    words.emplace_back("--help");
    const Finished own = course(words);
    CHECK(own.code == 0);
    CHECK_THAT(own.out, ContainsSubstring(example));
    CHECK(own.out.find("Exit codes:") == std::string::npos);
}

TEST_CASE("help names every command with its group, the exit codes and an example; so does each command's own") {
    const SmallCourse course;
    const Finished help = course({"--help"});
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    for (const char *words : {"For students:", "For instructors:", "For authors:", "Exit codes:", "130", "Example: "})
        CHECK_THAT(help.out, ContainsSubstring(words));

    for (const std::string command : {"check", "list", "hint", "solution", "reset", "run", "plot", "play", "debug",
                                      "bug", "mytests", "doctor", "setup", "test", "dev"})
        check_help(course, help.out, {command});
    CHECK(course({}).out == help.out);
}

TEST_CASE("what only authors type is listed by `dev`, and nowhere else") {
    const SmallCourse course;
    const Finished list = course({"dev"}), help = course({"--help"});
    CHECK(list.code == 0);
    CHECK(list.err.empty());
    CHECK(course({"dev", "--help"}).out == list.out);
    for (const std::string command : {"new", "weave", "publish", "release", "bench"}) {
        check_help(course, list.out, {"dev", command});
        CHECK_THAT(help.out, !ContainsSubstring("\n  " + command + " "));
    }
}

TEST_CASE("an option means the same before its command and after it") {
    const SmallCourse course;
    CHECK(course({"--all", "hint", "7.1"}).out == course({"hint", "7.1", "--all"}).out);
    CHECK(course({"--help", "hint"}).out == course({"hint", "--help"}).out);
    CHECK_THAT(course({"--al", "hint", "7.1"}).err, ContainsSubstring("`hint` has no option `--al`"));
    CHECK_THAT(course({"--verbose"}).err, ContainsSubstring("`course` has no option `--verbose`"));
}

TEST_CASE("the program says its version") {
    CHECK_THAT(SmallCourse{}({"--version"}).out, Matches("Frame by Frame \\d+\\.\\d+\\.\\d+\n"));
}

TEST_CASE("a checkout that has moved away is said in one sentence") {
    const SmallCourse course;
    const Finished said = course({"list"}, {"COURSE_ROOT=/nowhere/at/all"});
    CHECK(said.code == 2);
    CHECK_THAT(said.err, ContainsSubstring("the course is not in /nowhere/at/all"));
}

TEST_CASE("output that cannot be written is no success") {
    const SmallCourse course;
    const std::string line = "\"$@\" > /dev/full";
    std::vector<std::string> command{"sh", "-c", line, "sh"};
    for (const std::string &word : course.command({"list"})) command.push_back(word);
    const Finished said = run(command);
    CHECK(said.code == 4);
    CHECK_THAT(said.err, ContainsSubstring("cannot write the output"));
}

// ---- Programs that are run

TEST_CASE("run returns a program's output and exit code, and gives it no input") {
    const Finished done = run({"sh", "-c", "cat; echo out; echo err >&2; exit 7"});
    CHECK(done.code == 7);
    CHECK(done.out == "out\n");
    CHECK(done.err == "err\n");
    CHECK(run({"sh", "-c", "kill -SEGV $$"}).code == 128 + SIGSEGV);
    CHECK_THAT(run({"pwd"}, {.folder = "/"}).out, ContainsSubstring("/"));
}

TEST_CASE("a program's output is kept up to 16 MB, and the rest is not waited for in vain") {
    const Finished done = run({"sh", "-c", "head -c 40000000 /dev/zero; echo end >&2"});
    CHECK(kilobytes(done.out) == 16 * 1024);
    CHECK(done.err == "end\n");
}

TEST_CASE("a deadline ends a program and its children, and so does the end of their parent's pipe") {
    const auto begin = std::chrono::steady_clock::now();
    const Finished late = run({"sh", "-c", "sleep 60 & echo $!; sleep 60"}, {.deadline = 0.3});
    CHECK(late.timed_out);
    CHECK(late.code == 128 + SIGKILL);
    CHECK(ends_soon(late.out));

    const Finished done = run({"sh", "-c", "sleep 60 & echo $!"}); // the child holds the pipe
    CHECK(done.code == 0);
    ::kill(std::stoi(done.out), SIGKILL);
    CHECK(std::chrono::steady_clock::now() - begin < 10s);
}

TEST_CASE("a program that only sleeps, and whatever it has started, too, is ended; one that computes is not") {
    CHECK(run({"sh", "-c", "sleep 60 & sleep 60; :"}, {.deadline = 30, .idle_limit = 0.3}).timed_out);
    const Finished busy =
        run({"sh", "-c", "sh -c 'while :; do :; done'; exit 7"}, {.idle_limit = 0.3, .limits = {.processor_time = 2}});
    CHECK_FALSE(busy.timed_out);
    CHECK(busy.code == 7);
}

TEST_CASE("a program may use no more memory, time and disk than it is given") {
    const auto ends_with = [](const char *script, const Limits &limits) {
        return run({"sh", "-c", script}, {.deadline = 60, .limits = limits}).code;
    };
    CHECK(ends_with("while :; do :; done", {.processor_time = 1}) == 128 + SIGXCPU);
    CHECK(ends_with("f=$(mktemp) && exec 3>$f && rm $f && exec head -c 2000 /dev/zero >&3", {.file_size = 1000})
          == 128 + SIGXFSZ);
    CHECK(run({"sh", "-c", "ulimit -v"}, {.limits = {.memory = 512u << 20}}).out == "524288\n");
    CHECK(run({"sh", "-c", "echo $ONE $HOME $LC_ALL"}, {.environment = {"ONE=one"}}).out == "one\n");
}

TEST_CASE("a program that is not there is named, with what to do") {
    CHECK_THROWS_MATCHES(
        run({"no-such-program"}), UserError,
        MessageMatches(ContainsSubstring("cannot start no-such-program") && ContainsSubstring("doctor")));
}

TEST_CASE("Ctrl-C reaches the program that is run, ends its children too, and then `course`, with 130") {
    const SmallCourse course;
    const int signal = GENERATE(SIGINT, SIGTERM);
    const std::string path = course.instead_of("cmake", "cd '" + course.workspace.root.string() + R"('
trap 'echo > tidied; exit 1' INT TERM
sleep 60 &
echo $! > draft
echo $$ >> draft
mv draft pids
wait)");
    const fs::path pids = course.workspace.root / "pids";
    CHECK(stopped(course.command({"debug", "7"}, {path}), signal, [&] { return fs::exists(pids); }) == 128 + signal);
    CHECK(course.has("tidied"));
    std::ifstream lines{pids};
    for (std::string pid; std::getline(lines, pid);) CHECK(ends_soon(pid));
}

TEST_CASE("a program that does not heed Ctrl-C is ended a second later") {
    const SmallCourse course;
    const std::string path = course.instead_of(
        "cmake", "trap '' INT; echo > '" + (course.workspace.root / "ready").string() + "'; sleep 60; sleep 60");
    const auto begin = std::chrono::steady_clock::now();
    CHECK(stopped(course.command({"debug", "7"}, {path}), SIGINT, [&] { return course.has("ready"); }) == 130);
    CHECK(std::chrono::steady_clock::now() - begin < 30s);
}

// ---- The lock

TEST_CASE("a second command waits, says for which one, and goes on when the first is done") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    course.instead_of("gdb", "exit 0");
    const fs::path lock = course.workspace.build / ".lock";
    course.write(lock, "./course (process 12345)\n");
    const int held = ::open(lock.c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(::flock(held, LOCK_EX) == 0);

    Finished second;
    std::thread other{[&] { second = course({"debug", "7"}, {path}); }};
    std::this_thread::sleep_for(1s);
    ::close(held);
    other.join();
    CHECK(second.code == 0);
    CHECK_THAT(second.err, ContainsSubstring("Waiting for ./course (process 12345)"));

    const Finished alone = course({"debug", "7"}, {path});
    CHECK(alone.code == 0);
    CHECK(alone.err.find("Waiting") == std::string::npos);
}

TEST_CASE("what the holder of the lock starts does not wait for it, and waiting ends with Ctrl-C") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    course.instead_of("gdb", "exit 0");
    course.write(course.workspace.build / ".lock", "");
    const int held = ::open((course.workspace.build / ".lock").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(::flock(held, LOCK_EX) == 0);
    CHECK(course({"debug", "7"}, {path, "COURSE_LOCKED=yes"}).code == 0);

    const auto begin = std::chrono::steady_clock::now();
    CHECK(stopped(course.command({"debug", "7"}, {path}), SIGINT,
                  [&] { return std::chrono::steady_clock::now() - begin > 800ms; })
          == 130);
    ::close(held);
}

TEST_CASE("a lock is let go when it is destroyed, and names its holder meanwhile") {
    const SmallCourse course;
    const fs::path path = course.workspace.build / ".lock";
    ::unsetenv("COURSE_LOCKED");
    {
        const Lock lock{course.workspace};
        CHECK_THAT(read_file(path), ContainsSubstring(std::to_string(::getpid())));
        CHECK(std::getenv("COURSE_LOCKED") != nullptr);
        const int other = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
        CHECK(::flock(other, LOCK_EX | LOCK_NB) != 0);
        ::close(other);
    }
    CHECK(std::getenv("COURSE_LOCKED") == nullptr);
    CHECK(read_file(path).empty());
    const int other = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    CHECK(::flock(other, LOCK_EX | LOCK_NB) == 0);
    ::close(other);
}

TEST_CASE("a build folder that cannot be written is said in one sentence") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    course.instead_of("gdb", "exit 0");
    course.write("a file", "");
    const Finished said = course({"debug", "7"}, {path, "COURSE_BUILD=" + (course.workspace.root / "a file").string()});
    CHECK(said.code == 2);
    CHECK_THAT(said.err,
               ContainsSubstring("cannot write in the build folder") && ContainsSubstring("COURSE_BUILD=FOLDER"));
}

// ---- What is remembered

TEST_CASE("the states of exercises, and the rungs of hints, are remembered") {
    const SmallCourse course;
    const Workspace &workspace = course.workspace;
    CHECK(recall(workspace, course.seven()).empty());
    remember(workspace, course.seven(), {{"7.1", "passed"}, {"7.2", "wrong"}});
    remember(workspace, course.seven(), {{"7.2", "crashed"}});
    remember(workspace, workspace.section("6"), {{"6.1", "passed"}});

    const auto known = recall(workspace, course.seven());
    REQUIRE(known.size() == 2);
    CHECK(known.at("7.1").state == "passed");
    CHECK(known.at("7.2").state == "crashed");
    CHECK(known.at("7.2").file == fingerprint(workspace.exercise(course.seven())));
    CHECK_THAT(known.at("7.1").when, Matches("20\\d\\d-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ"));

    CHECK(take_rung(workspace, "7.1", 9) == 0);
    remember_rungs(workspace, "7.1", 2);
    CHECK(take_rung(workspace, "7.1", 9) == 2);
    CHECK(take_rung(workspace, "7.2", 9) == 0);
}

TEST_CASE("commands that run at the same time do not lose each other's state") {
    const SmallCourse course;
    constexpr unsigned commands = 8, each = 20;
    std::vector<pid_t> children;
    for (unsigned command = 0; command < commands; ++command) {
        children.push_back(::fork());
        if (children.back() != 0) continue;
        const std::string own = "7." + std::to_string(10 + command);
        for (unsigned i = 0; i < each; ++i) {
            take_rung(course.workspace, "7.1", 1000);
            remember(course.workspace, course.seven(), {{own, "passed"}});
        }
        ::_exit(0);
    }
    for (const pid_t child : children) ::waitpid(child, nullptr, 0);
    CHECK(take_rung(course.workspace, "7.1", 1000) == commands * each);
    CHECK(recall(course.workspace, course.seven()).size() == commands);
}

TEST_CASE("a broken state file counts as empty, and is rewritten") {
    const SmallCourse course;
    const std::string broken =
        GENERATE("", "{", "not json", "[1, 2]", "null", "\xFF\xFE", R"({"07_wall_meeting": 3, "7.1": "two"})",
                 R"({"07_wall_meeting": {"7.1": [], "7.2": {"state": 4}}, "7.1": -4})",
                 R"({"07_wall_meeting": {"7.1": {}}, "7.1": 1e300})");
    CAPTURE(broken);
    course.write(".course/progress.json", broken);
    course.write(".course/hints.json", broken);
    CHECK(recall(course.workspace, course.seven()).empty());
    CHECK(course({"list"}).code == 0);
    CHECK_THAT(course({"hint", "7.1"}).out, StartsWith("7.1, hint 1 of 2"));
    remember(course.workspace, course.seven(), {{"7.1", "passed"}});
    CHECK(recall(course.workspace, course.seven()).at("7.1").state == "passed");
    CHECK(take_rung(course.workspace, "7.1", 9) == 1);
}

TEST_CASE("where state cannot be saved, a command says so and goes on") {
    const SmallCourse course;
    course.write(".course", "a file in the folder's place");
    const Finished said = course({"hint", "7.1"});
    CHECK(said.code == 0);
    CHECK_THAT(said.out, ContainsSubstring("Under the first stone."));
    CHECK_THAT(said.err, ContainsSubstring("this is not remembered"));
}

// ---- list

TEST_CASE("list shows sections and exercises as they stood, and what to do next") {
    const SmallCourse course;
    CHECK(course({"list"}).out == R"(6 Reflection: 0 of 2 passed
  6.1   core       first_bounce   not started
  6.2   stretch    second_bounce  not started

7 Walls that meet: 0 of 2 passed
  7.1   core       first   not started
  7.2   stretch    second  not started

Next: 6.1, `first_bounce`, in exercises/06_reflection.cpp; then ./course check 6
)");

    course.write("exercises/06_reflection.cpp", "done");
    course.write("exercises/07_wall_meeting.cpp", "half done");
    CHECK_THAT(course({"list"}).out, ContainsSubstring("6.1   core       first_bounce   not checked"));

    remember(course.workspace, course.workspace.section("6"), {{"6.1", "passed"}, {"6.2", "passed"}});
    remember(course.workspace, course.seven(), {{"7.1", "passed"}, {"7.2", "too long"}});
    const std::string listed = course({"list"}).out;
    CHECK_THAT(listed, ContainsSubstring("6 Reflection: 2 of 2 passed")
                           && ContainsSubstring("7 Walls that meet: 1 of 2 passed")
                           && ContainsSubstring("second  too long\n")
                           && ContainsSubstring("Next: ./course check 7 (7.2: too long; ./course hint 7.2 helps)"));
    CHECK(listed.find("changed") == std::string::npos);

    remember(course.workspace, course.seven(), {{"7.1", "needs 7.2 second"}, {"7.2", "not started"}});
    CHECK_THAT(course({"list"}).out, ContainsSubstring("Next: 7.2, `second`, in exercises/07_wall_meeting.cpp"));

    remember(course.workspace, course.seven(), {{"7.1", "passed"}, {"7.2", "passed"}});
    CHECK_THAT(course({"list"}).out, ContainsSubstring("All exercises are passed."));
}

TEST_CASE("list, hint and check go on where the pages do: in the section that was judged last, until it's reset") {
    const SmallCourse course;
    course.write("exercises/07_wall_meeting.cpp", "half done");
    remember(course.workspace, course.seven(), {{"7.1", "passed"}, {"7.2", "wrong"}});
    CHECK_THAT(course({"list"}).out, ContainsSubstring("Next: ./course check 7 (7.2: wrong;"));
    CHECK_THAT(course({"hint"}).out, StartsWith("7.2"));
    CHECK_THAT(progress_script(course.workspace), ContainsSubstring(R"("next":{"number":"7.2")"));
    course.write("exercises/07_wall_meeting.cpp", course.read(course.workspace.stub(course.seven())));
    CHECK_THAT(course({"list"}).out, ContainsSubstring("Next: 6.1, `first_bounce`"));
    CHECK(progress_script(course.workspace).find("next") == std::string::npos);
}

TEST_CASE("list says when a file has changed since its check, is empty again, or is gone") {
    const SmallCourse course;
    const fs::path file = course.workspace.exercise(course.workspace.section("6"));
    course.write(file, "mine");
    remember(course.workspace, course.workspace.section("6"), {{"6.1", "passed"}, {"6.2", "passed"}});

    course.write(file, "mine, and better");
    CHECK_THAT(course({"list"}).out, ContainsSubstring("exercises/06_reflection.cpp has changed since the last check.")
                                         && ContainsSubstring("Next: ./course check 6"));

    course.write(file, course.read(course.workspace.stub(course.workspace.section("6"))));
    CHECK_THAT(course({"list"}).out, ContainsSubstring("6 Reflection: 0 of 2 passed"));

    fs::remove(file);
    CHECK_THAT(
        course({"list"}).out,
        ContainsSubstring("exercises/06_reflection.cpp is not there; `./course reset 6` brings the empty one back.")
            && ContainsSubstring("6 Reflection: 2 of 2 passed") && ContainsSubstring("Next: ./course reset 6"));
}

TEST_CASE("a section that is not built yet is listed as such, and a broken catalogue is named") {
    const SmallCourse course;
    fs::remove(course.workspace.build / "catalogue" / "06_reflection.json");
    const Finished listed = course({"list"});
    CHECK(listed.code == 0);
    CHECK_THAT(listed.out, StartsWith("6 Reflection: not built yet\n") && ContainsSubstring("7.1   core")
                               && ContainsSubstring("Next: ./course, which builds it"));
    CHECK_THAT(course({"hint", "6.1"}).err, ContainsSubstring("06_reflection isn't built yet: type ./course"));
    CHECK(course({"hint", "second"}).code == 0);

    course.write(course.workspace.build / "catalogue" / "06_reflection.json",
                 GENERATE("{]", "[]", R"({"exercises": [{"number": 7}]})"));
    const Finished broken = course({"list"});
    CHECK(broken.code == 2);
    CHECK_THAT(broken.err, ContainsSubstring("06_reflection.json is broken: delete it"));
}

// ---- hint, solution

TEST_CASE("hints come one by one, the last names the solution, and --again starts from the first") {
    const SmallCourse course;
    const std::string first = "7.1, hint 1 of 2: where to begin\n\nUnder the first stone.\n\n",
                      last = "7.1, hint 2 of 2: the first line\n\nreturn 1;\n\n";
    CHECK(course({"hint", "7.1"}).out == first + "The next one: ./course hint 7.1\n");
    CHECK(course({"hint", "first"}).out == last + "That was the last one. `./course solution 7.1` shows ours.\n");
    const Finished seen = course({"hint", "07.1"});
    CHECK(seen.code == 0);
    CHECK(seen.out
          == "You have seen all hints of 7.1; `./course hint 7.1 --all` shows them again. `./course solution 7.1` "
             "shows ours.\n");
    CHECK(course({"hint", "7.1", "--again"}).out == first + "The next one: ./course hint 7.1\n");
    CHECK_THAT(course({"hint", "7.1"}).out, StartsWith(last));
    CHECK(course({"hint", "7.1", "--all"}).out
          == first + last + "That was the last one. `./course solution 7.1` shows ours.\n");
    CHECK_THAT(course({"hint", "6.1"}).out, StartsWith("6.1 has no hints"));
}

TEST_CASE("a solution is its own chunks and the helpers that it uses, ready to compile") {
    SmallCourse course;
    CHECK(course({"solution", "7.1"}).out == "int first() { return 1; }\n"); // which needs no helper
    CHECK(course({"solution", "second"}).out == "int two() { return 2; }\n\nint second() { return two(); }\n");
    CHECK_THAT(course({"solution", "second", "--others"}).err, ContainsSubstring("no other answers to 7.2"));
    course.write("tests/07_wall_meeting/variants.diff", "7.2 by_a_sum: one and one\n-int second() { return two(); }\n"
                                                        "+int second() { return 1 + 1; }\n");
    CHECK(course({"solution", "second", "--others"}).out
          == "// by a sum: one and one\nint second() { return 1 + 1; }\n");
}

TEST_CASE("a hint without an exercise is for the first that is not passed") {
    const SmallCourse course;
    CHECK_THAT(course({"hint"}).out, StartsWith("6.1 has no hints"));
    course.write(course.workspace.exercise(course.workspace.section("6")), "// all of it done\n");
    remember(course.workspace, course.workspace.section("6"), {{"6.1", "passed"}, {"6.2", "passed"}});
    CHECK_THAT(course({"hint"}).out, StartsWith("7.1"));
}

// ---- reset

TEST_CASE("reset keeps a copy of what it replaces, another one each time") {
    const SmallCourse course;
    const fs::path file = course.workspace.exercise(course.seven());
    const std::string mine{"mine\r\n\0\xFF", 8}, empty = course.read(course.workspace.stub(course.seven()));
    course.write(file, mine);

    const Finished done = course({"reset", "7", "--yes"});
    CHECK(done.code == 0);
    CHECK(course.read(file) == empty);
    REQUIRE(course.kept().size() == 1);
    CHECK(read_file(course.kept()[0]) == mine);
    CHECK_THAT(course.kept()[0].filename().string(), Matches("07_wall_meeting-20\\d\\d-\\d\\d-\\d\\d-\\d{6}\\.cpp"));
    CHECK_THAT(done.out, ContainsSubstring(".course/kept/" + course.kept()[0].filename().string()));

    for (const char *more : {"second", "third", "fourth"}) { // within one second
        course.write(file, more);
        CHECK(course({"reset", "7", "--yes"}).code == 0);
    }
    CHECK(course.kept().size() == 4);

    CHECK_THAT(course({"reset", "7", "--yes"}).out, ContainsSubstring("is the empty one already"));
    CHECK(course.kept().size() == 4);
}

TEST_CASE("reset brings a deleted exercise back without a question") {
    const SmallCourse course;
    fs::remove_all(course.workspace.root / "exercises");
    CHECK(course({"reset", "wall"}).code == 0);
    CHECK(course.read("exercises/07_wall_meeting.cpp") == course.read(course.workspace.stub(course.seven())));
    CHECK(course.kept().empty());
}

TEST_CASE("without a terminal and without --yes, reset refuses; so it does when no copy can be kept") {
    const SmallCourse course;
    course.write("exercises/07_wall_meeting.cpp", "mine");
    const Finished said = course({"reset", "7"});
    CHECK(said.code == 2);
    CHECK_THAT(said.err, ContainsSubstring("./course reset 7 --yes"));
    CHECK(course.read("exercises/07_wall_meeting.cpp") == "mine");

    course.write(".course", "a file in the folder's place");
    CHECK(course({"reset", "7", "--yes"}).code == 2);
    CHECK(course.read("exercises/07_wall_meeting.cpp") == "mine");
}

TEST_CASE("on a terminal reset asks, and only a yes is a yes") {
    const SmallCourse course;
    const auto [answer, replaced] = GENERATE(table<std::string, bool>(
        {{"y\n", true}, {"yes\n", true}, {"n\n", false}, {"\n", false}, {"\x04", false}, {"yesterday\n", false}}));
    CAPTURE(answer);
    course.write("exercises/07_wall_meeting.cpp", "mine");
    const Finished done = on_terminal(course.command({"reset", "7"}), answer);
    CHECK(done.code == 0);
    CHECK_THAT(done.out, ContainsSubstring("Replace exercises/07_wall_meeting.cpp by the empty one?"));
    CHECK((course.read("exercises/07_wall_meeting.cpp") != "mine") == replaced);
    CHECK(course.kept().size() == (replaced ? 1 : 0));
}

TEST_CASE("Ctrl-C at the question leaves with 130, and all as it was") {
    const SmallCourse course;
    course.write("exercises/07_wall_meeting.cpp", "mine");
    CHECK(on_terminal(course.command({"reset", "7"}), "\x03").code == 130);
    CHECK(course.read("exercises/07_wall_meeting.cpp") == "mine");
    CHECK(course.kept().empty());
}

// ---- run, debug, a missing exercise

TEST_CASE("run passes the program's output on unchanged, and says elsewhere where the traces are") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    const fs::path program = course.workspace.build / "chapters" / "07_wall_meeting";
    course.write_program(program, "printf 'a  \\r\\n\\tb'; echo $# $1 >&2");

    const Finished done = course({"run", "7"}, {path});
    CHECK(done.code == 0);
    CHECK(done.out == "a  \r\n\tb");
    CHECK_THAT(done.err, StartsWith("2 --out\n") && ContainsSubstring("traces")
                             && ContainsSubstring(course.workspace.build.string()));

    course.write_program(program, "echo one; exit 4");
    const Finished broken = course({"run", "7"}, {path});
    CHECK(broken.code == 3);
    CHECK(broken.out == "one\n");
    CHECK_THAT(broken.err, ContainsSubstring("exit code 4"));
}

TEST_CASE("run hands the name of a part to the program, and an unknown one is answered by its list") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    for (const std::string folder : {"chapters", "mine"}) {
        course.write_program(course.workspace.build / folder / "07_wall_meeting",
                             "[ $1 = walls ] || { echo 'no such part; its parts are walls' >&2; exit 2; }\necho $1 $2");
        std::vector<std::string> run{"run", "7", "walls"}, misspelt{"run", "7", "wals"};
        if (folder == "mine") run.push_back("--mine"), misspelt.push_back("--mine");

        const Finished done = course(run, {path});
        CHECK(done.code == 0);
        CHECK(done.out == "walls --out\n");
        CHECK(done.err.empty());

        const Finished unknown = course(misspelt, {path});
        CHECK(unknown.code == 2);
        CHECK_THAT(unknown.err, ContainsSubstring("no such part; its parts are walls"));
    }
}

TEST_CASE("a student's program that fails exits with 1: there is something to do") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    course.write_program(course.workspace.build / "mine" / "07_wall_meeting", "echo 6; kill -SEGV $$");
    const Finished done = course({"run", "7", "--mine"}, {path});
    CHECK(done.code == 1);
    CHECK(done.out == "6\n");
    CHECK_THAT(done.err, ContainsSubstring("crashed"));

    course.instead_of("cmake", "echo 'exercises/07.cpp:3:1: error: no'; exit 1");
    const Finished unbuilt = course({"run", "7", "--mine"}, {path});
    CHECK(unbuilt.code == 1);
    CHECK_THAT(unbuilt.err, ContainsSubstring("07.cpp:3: no"));
}

TEST_CASE("debug builds the one-process tests and prints the debugger's command") {
    const SmallCourse course;
    const std::string path =
        course.instead_of("cmake", "echo \"$@\" > '" + (course.workspace.root / "asked").string() + "'");
    course.instead_of("gdb", "exit 0");
    const std::string program = "'" + (course.workspace.build / "debug" / "07_wall_meeting").string() + "'";

    const Finished done = course({"debug", "7"}, {path});
    CHECK(done.code == 0);
    CHECK(done.out == "gdb -q --args " + program + "\n");
    CHECK(course.read("asked") == "--build " + course.workspace.build.string() + " --target 07_wall_meeting_debug\n");
    CHECK(course({"debug", "7.2", "--print"}, {path}).out
          == "gdb -q -ex 'break wall_meeting::second' --args " + program + " '[7.2]'\n");

    course.instead_of("cmake", "echo 'x.cpp:3: error: no'; exit 1");
    const Finished broken = course({"debug", "7"}, {path});
    CHECK(broken.code == 1);
    CHECK(broken.out.empty());
    CHECK_THAT(broken.err, ContainsSubstring("x.cpp:3: error: no") && ContainsSubstring("./course check 7"));
}

TEST_CASE("on a terminal the debugger is started, and without one it is named") {
    const SmallCourse course;
    course.instead_of("cmake", "exit 0");
    const std::string path = course.instead_of("gdb", "echo gdb was here: $*");
    CHECK_THAT(on_terminal(course.command({"debug", "7"}, {path}), "").out,
               ContainsSubstring("gdb was here: -q --args"));
    CHECK(on_terminal(course.command({"debug", "7", "--print"}, {path}), "").out.find("was here") == std::string::npos);

    const std::string only = "PATH=" + (course.workspace.root / "bin").string();
    fs::remove(course.workspace.root / "bin" / "gdb");
    const std::vector<std::string> line = course.command({"debug", "7"}, {only});
    const Finished none = run(line);
    CHECK(none.code == 2);
    CHECK_THAT(none.err, ContainsSubstring("install gdb"));
}

TEST_CASE("a missing exercise is named everywhere, with the way back") {
    const SmallCourse course;
    const std::string path = course.instead_of("cmake", "exit 0");
    fs::remove(course.workspace.exercise(course.seven()));
    for (const std::vector<std::string> &words : std::vector<std::vector<std::string>>{
             {"debug", "7"}, {"run", "7", "--mine"}, {"check", "7"}, {"plot", "7", "--mine"}}) {
        CAPTURE(words);
        const Finished said = course(words, {path});
        CHECK(said.code == 2);
        CHECK(said.err
              == "course: exercises/07_wall_meeting.cpp is not there; `./course reset 7` brings the empty one back.\n");
    }
}

// ---- Colour

TEST_CASE("colour is used on a terminal only, and not if NO_COLOR is set") {
    const SmallCourse course;
    const auto colourful = [](const Finished &done) { return done.out.find('\033') != std::string::npos; };
    CHECK(colourful(on_terminal(course.command({"list"}, {"TERM=xterm"}), "")));
    CHECK(colourful(on_terminal(course.command({"list"}, {"NO_COLOR=", "TERM=xterm"}), "")));
    CHECK_FALSE(colourful(on_terminal(course.command({"list"}, {"NO_COLOR=1", "TERM=xterm"}), "")));
    CHECK_FALSE(colourful(on_terminal(course.command({"list"}, {"TERM=dumb"}), "")));
    CHECK_FALSE(colourful(course({"list"}, {"TERM=xterm"})));
}
