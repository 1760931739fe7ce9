// `course bug`: from the buggy file to the name of the law that it broke. That each bug of tests/bugs.txt breaks its law is
// tested by tests/bugs.mjs.

#include "small_course.hpp"

#include "base/text.hpp"
#include "book/html.hpp"
#include "check/bugs.hpp"
#include "check/progress_store.hpp"
#include "site/spot_the_bug.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using namespace course;
namespace fs = std::filesystem;

namespace {

/// This course, as it was built, with exercises and a memory of its own.
struct OwnExercises {
    OwnExercises() { write_file(workspace.exercise(seven), read_file(workspace.stub(seven))); }

    Finished operator()(std::vector<std::string> words) const {
        return run(course_command(workspace, words, {"NO_COLOR=1"}));
    }
    Finished bug(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"bug", "7"});
        return (*this)(more);
    }

    std::string text() const { return read_file(file); }
    void write(const std::string &code) const { write_file(file, code); }
    void mend() const { write(read_file(workspace.solution(seven))); }

    /// `A` for a law in the place of the first one.
    static std::string letter(const Bug &bug, bool right) {
        const auto law =
            std::ranges::find_if(bug.laws, [&](const std::string &l) { return (l == bug.broken) == right; });
        return std::string{static_cast<char>('A' + (law - bug.laws.begin()))};
    }

    std::vector<fs::path> kept() const { return files_in(workspace.memory() / "kept"); }

    static Workspace tree_in(const fs::path &folder) {
        link_all_but({"build", ".git", ".course", "exercises"}, COURSE_ROOT, folder);
        return {folder, COURSE_BUILD};
    }

    OwnFolder folder{"own exercises XXXXXX"};
    Workspace workspace = tree_in(folder.path);
    Section seven = workspace.section("7");
    std::vector<Bug> bugs = bugs_of(workspace, seven);
    fs::path file = workspace.bug(seven);
};

} // namespace

TEST_CASE("a bug is written, looked at, mended, and found once its law is named") {
    const OwnExercises course;
    REQUIRE(course.bugs.size() == 3);
    const Bug &first = course.bugs.front();
    const BuggyCode made = code_of(course.workspace, course.seven, first);

    const Finished begun = course.bug();
    INFO(begun.err);
    CHECK(begun.code == 0);
    CHECK_THAT(begun.out, StartsWith("Bug 1 of 3 is in exercises/07_bug.cpp: our " + first.exercise)
                              && ContainsSubstring("./course play 7 --bug")
                              && ContainsSubstring("You haven't passed " + first.exercise + " yet"));
    CHECK_THAT(course.text(), StartsWith("// Section 7, bug 1 of 3: our `") && ContainsSubstring(made.text));
    CHECK(course.text().find(made.claim) == std::string::npos);
    CHECK_THAT(course({"list"}).out, ContainsSubstring("bugs found: 0 (./course bug 7)"));

    const Finished unchanged = course.bug();
    CHECK(unchanged.code == 1);
    CHECK_THAT(unchanged.out, StartsWith("You haven't changed exercises/07_bug.cpp yet.")
                                  && ContainsSubstring("tests of " + first.exercise + " are red"));
    for (const std::string &told : {first.broken, made.claim}) CHECK(unchanged.out.find(told) == std::string::npos);

    const Finished shown = course.bug({"-v"});
    CHECK(shown.code == 1);
    CHECK_THAT(shown.out, ContainsSubstring("✗ " + first.exercise) && ContainsSubstring("returned"));
    CHECK(shown.out.find(made.claim) == std::string::npos);

    const Finished too_early = course.bug({"--law", course.letter(first, true)});
    CHECK(too_early.code == 1);
    CHECK_THAT(too_early.out, ContainsSubstring("are red"));

    course.mend();
    const Finished mended = course.bug();
    CHECK(mended.code == 0);
    CHECK_THAT(mended.out, ContainsSubstring("Which law did the bug break?"));
    for (const std::string &law : first.laws) CHECK_THAT(mended.out, ContainsSubstring(law));

    const Finished no_letter = course.bug({"--law", "E"});
    CHECK(no_letter.code == 2);
    CHECK_THAT(no_letter.err, ContainsSubstring("--law wants one of the letters A to D, not `E`"));
    const Finished no = course.bug({"--law", course.letter(first, false)});
    CHECK(no.code == 1);
    CHECK_THAT(no.out, StartsWith("No: the bug left that one green: "));
    CHECK(recall_hunt(course.workspace, course.seven).found.empty());

    const Finished yes = course.bug({"--law", lower(course.letter(first, true))});
    CHECK(yes.code == 0);
    CHECK_THAT(yes.out, StartsWith("Right: " + first.broken) && ContainsSubstring(made.claim)
                            && ContainsSubstring("The next one: ./course bug 7"));
    CHECK_THAT(course({"list"}).out, ContainsSubstring("bugs found: 1"));

    const std::string mine = course.text();
    const Finished next = course.bug();
    CHECK_THAT(next.out, ContainsSubstring("Bug 2 of 3") && ContainsSubstring("is kept: .course/kept/07_bug-20"));
    REQUIRE(course.kept().size() == 1);
    CHECK(read_file(course.kept().front()) == mine);
    CHECK_THAT(course.text(), ContainsSubstring(code_of(course.workspace, course.seven, course.bugs[1]).text));
}

TEST_CASE("a bug whose file doesn't compile says where; one whose file is deleted comes back") {
    const OwnExercises course;
    course.bug();
    const std::string fresh = course.text();
    course.write(fresh + "\nint broken(\n");
    const Finished said = course.bug();
    CHECK(said.code == 1);
    CHECK_THAT(said.out, ContainsSubstring("exercises/07_bug.cpp does not compile"));
    CHECK(course.text() != fresh); // it's the student's
    fs::remove(course.file);
    CHECK(course.bug().code == 0);
    CHECK(course.text() == fresh);
}

TEST_CASE("bugs that are all found come back with --again, and so they do after reset") {
    const OwnExercises course;
    Hunt all;
    for (const Bug &bug : course.bugs) all.found.insert(all.begun = bug.name);
    remember_hunt(course.workspace, course.seven, all);
    CHECK_THAT(course.bug().out, StartsWith("You've found all 3 bugs of section 7."));
    CHECK_FALSE(fs::exists(course.file));
    CHECK_THAT(course.bug({"--again"}).out, StartsWith("Bug 1 of 3"));
    const std::string untouched = course.text();
    course.bug({"--again"});
    CHECK(course.kept().empty()); // it was as it had been written

    course.write(untouched + "// mine\n");
    const Finished reset = course({"reset", "7"});
    CHECK_THAT(reset.out, ContainsSubstring("exercises/07_bug.cpp is gone. Yours is kept: .course/kept/07_bug-20"));
    CHECK_FALSE(fs::exists(course.file));
    CHECK(course.kept().size() == 1);
    const Hunt hunt = recall_hunt(course.workspace, course.seven);
    CHECK((hunt.begun.empty() && hunt.found.empty()));
    CHECK(course({"list"}).out.find("bugs found") == std::string::npos);
}

TEST_CASE("a bug is shown beside what's right, with four causes of which one is it; without answers there is none") {
    const OwnExercises course;
    const auto bug = std::ranges::find_if(course.bugs, [](const Bug &each) { return each.others.size() == 3; });
    REQUIRE(bug != course.bugs.end());
    const Causes causes = causes_of(course.workspace, course.seven, *bug);
    const std::vector<Demo> all = demos(course.workspace);
    const auto demo = std::ranges::find(all, course.seven.name, [](const Demo &each) { return each.section.name; });
    REQUIRE(demo != all.end());
    CHECK(std::ranges::is_sorted(causes.all));
    const std::string claim = code_of(course.workspace, course.seven, *bug).claim,
                      html = spot_the_bug(course.workspace, *demo);
    CHECK_THAT(claim, StartsWith(causes.all.at(causes.right)));
    CHECK_THAT(html, ContainsSubstring("data-bug=\"" + bug->exercise + ' ')
                         && ContainsSubstring("data-cause=\"" + std::to_string(causes.right) + '"'));
    for (const std::string &cause : causes.all) CHECK_THAT(html, ContainsSubstring(escaped(cause)));
    CHECK_FALSE(contains(html, "data-mine"));

    const SmallCourse without;
    CHECK(spot_the_bug(without.workspace, {without.seven(), {}, {}, ""}).empty());
}

TEST_CASE("a hunt says in one sentence what it lacks") {
    const SmallCourse course;
    CHECK_THAT(course({"bug", "7"}).err, ContainsSubstring("this course comes without our answers to section 7"));
    CHECK_THAT(course({"play", "--bug"}).err, ContainsSubstring("--bug needs a section"));
    CHECK_THAT(course({"play", "7", "--bug"}).err, ContainsSubstring("./course bug 7 puts a bug into it"));
    course.write("tests/07_wall_meeting/mutants.diff", "7.1 is_two: you return 2\n-int first() { return 1; }\n");
    course.write("tests/bugs.txt", "# none here\n6.1 another\n  breaks a law\n");
    CHECK_THAT(course({"bug", "7"}).err, ContainsSubstring("section 7 has no bugs to hunt yet"));
    CHECK_THAT(course({"bug", "7.1"}).err, ContainsSubstring("type ./course bug 7"));
    course.write("tests/bugs.txt", "7.1 no_such\n  breaks a law\n");
    CHECK(course({"bug", "7"}).code == 3);
}

TEST_CASE("a bug's file has the function, what it calls, and what that calls, and nothing else") {
    const SmallCourse course;
    course.write("solutions/07_wall_meeting.cpp", R"(#include "wall_meeting.hpp"
#include <cmath>

namespace wall_meeting {

//> Solution: helpers
namespace {
struct Hit {
    double time;
};
} // namespace
static int one() { return 1; } // always
static int two() { return one() + one(); }

//> Solution 7.1: one
/// What comes first.
int first() {
    Hit hit{1};

    return int(hit.time);
}

//> Solution: more
static int four() { return two() + two(); }
static int five() { return 5; }

//> Solution 7.2: two
int second() {
    if (four() > 3)
        return first();
    return four();
}
//>
} // namespace wall_meeting
)");
    course.write("tests/07_wall_meeting/mutants.diff", "7.2 is_three: you return 3\n-return first();\n+return 3;\n\n"
                                                       "7.2 is_more: you add 1\n return first();\n-return four();\n"
                                                       "+return first() + four();\n");
    const auto code = [&](const std::string &name) {
        return code_of(course.workspace, course.seven(), {.exercise = "7.2", .name = name});
    };
    CHECK(code("is_three").claim == "you return 3");
    CHECK(code("is_three").text == R"(#include "wall_meeting.hpp"

#include <cmath>

namespace wall_meeting {

static int one() { return 1; } // always

static int two() { return one() + one(); }

static int four() { return two() + two(); }

int second() {
    if (four() > 3)
        return 3;
    return four();
}

} // namespace wall_meeting
)");
    CHECK_THAT(code("is_more").text,
               ContainsSubstring("struct Hit {") && ContainsSubstring("    Hit hit{1};\n\n    return")
                   && ContainsSubstring("/// What comes first.\nint first() {")
                   && ContainsSubstring("    return first() + four();\n") && !ContainsSubstring("five"));
}
