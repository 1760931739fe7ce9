// `course check` as a command: one exercise alone; with --watch again whenever the file changes, again at Enter, and
// gone at q. What it says of a file is in tests/verdicts.

#include "ground/files.hpp"
#include "ground/process.hpp"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

std::size_t count(const std::string &text, const std::string &what) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += what.size()) ++found;
    return found;
}

course::Finished check(const std::string &what, const std::string &file) {
    return course::run({"env", "NO_COLOR=1", "COURSE_ROOT=" COURSE_ROOT, "COURSE_BUILD=" COURSE_BUILD, COURSE_TOOL,
                        "check", what, "--file", COURSE_ROOT "/" + file});
}

} // namespace

TEST_CASE("asked for one exercise, check speaks of no other, and leaves with its verdict") {
    const auto done = check("7.2", "solutions/07_segment_intersection.cpp");
    CHECK(done.out.starts_with("✓ 7.2 meet, core: "));
    CHECK(done.out.ends_with(" tests passed\nThe whole section: ./course check 7\n"));
    CHECK(count(done.out, "\n") == 2);
    CHECK(done.code == 0);

    const auto not_begun = check("7.2", "tests/stubs/07_segment_intersection.cpp");
    CHECK(not_begun.out == "· 7.2 meet, core: not started\nNext: 7.2 meet. Where to begin: ./course hint 7.2\n");
    CHECK(not_begun.code == 1);

    const auto other = check("7.2", "tests/verdicts/wrong_answer.cpp"); // of 7.1
    CHECK(count(other.out, "7.1") == 0);
    CHECK(check("7.9", "solutions/07_segment_intersection.cpp").code == 2);
}

TEST_CASE("a section that builds on another one has its own exercises only") {
    const std::string checked = check("11", "tests/stubs/11_particles.cpp").out;
    CHECK(count(checked, ": not started\n") == 9);
    CHECK(count(checked, " 7.") == 0);
}

TEST_CASE("a section's program prints one part alone, and lists its parts for a name that it does not know") {
    const std::string program = COURSE_BUILD "/chapters/07_segment_intersection";
    const auto whole = course::run({program, "--out", fs::temp_directory_path().string()});
    const auto part = course::run({program, "crossings"});
    CHECK(part.code == 0);
    CHECK(part.out.starts_with("motion "));
    CHECK(whole.out.starts_with(part.out + "\nfirst "));

    const auto unknown = course::run({program, "crosings"});
    CHECK(unknown.code == 2);
    CHECK(unknown.out.empty());
    CHECK(unknown.err == "this program has no part `crosings`; its parts are crossings, meetings, shared, touches\n");
    CHECK(course::run({program, "crossings", "meetings"}).code == 2);
}

TEST_CASE("watching judges at once, at each save and at Enter, and q leaves") {
    std::string name = (fs::temp_directory_path() / "watched XXXXXX").string();
    const fs::path folder = ::mkdtemp(name.data());
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
    fs::remove_all(folder);
}
