// `course check --watch`: again whenever the file changes, again at Enter, and gone at q.

#include "files.hpp"
#include "process.hpp"

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

} // namespace

TEST_CASE("watching judges at once, at each save and at Enter, and q leaves") {
    std::string name = (fs::temp_directory_path() / "watched XXXXXX").string();
    const fs::path folder = ::mkdtemp(name.data());
    const fs::path file = folder / "mine.cpp";
    fs::copy(fs::path{COURSE_ROOT} / "tests/verdicts/syntax_error.cpp", file); // judged by the compiler alone: quick

    // Keys at 3 s and 9 s, a save at 6 s; each judgement takes less than one.
    const std::string script =
        "(sleep 3; echo; sleep 3; echo '// more' >>\"$1\"; sleep 3; echo q) | "
        "env COURSE_ROOT='" COURSE_ROOT "' COURSE_BUILD='" COURSE_BUILD "' \"$2\" check 7 --watch --file \"$1\"";
    const auto watched = course::run({"sh", "-c", script, "sh", file.string(), COURSE_TOOL}, {.deadline = 60});
    CHECK(watched.code == 0);
    CHECK(count(watched.out, "does not compile") == 3);
    CHECK(count(watched.out, "Waiting for you to save.") == 3);
    fs::remove_all(folder);
}
