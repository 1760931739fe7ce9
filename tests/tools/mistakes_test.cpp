// Mistakes that have a name: a verdict's numbers are looked up among what comes out of mutants.

#include "check/mistakes.hpp"
#include "judge/protocol/signature.hpp"

#include <catch2/catch_test_macros.hpp>

#include <functional>

using namespace course;

namespace {

Verdict red(const std::string &test, const std::string &yours) {
    return {.exercise = "7.2",
            .test = test,
            .kind = Outcome::wrong,
            .call = Call{"meet", {"first = {start (4, 7) m}", "t = 0.25 s"}, 0, yours},
            .yours = yours};
}
Verdict green(const std::string &test) { return {.exercise = "7.2", .test = test}; }

/// What `check` finds out of a table with this mistake.
std::string line(const std::vector<Verdict> &failed, const std::string &words) {
    return "\n7.2\t" + signature(failed) + '\t' + words + '\n';
}

} // namespace

TEST_CASE("a mistake is known by what all failing tests saw, in any order") {
    const Verdict one = red("crosses", "t = 0.7"), other = red("touches", "t = 3");
    const std::string table = line({one, other}, "you swap them");
    CHECK(known_mistake(table, {one, green("misses"), other}) == "you swap them.");
    CHECK(known_mistake(table, {other, one}) == "you swap them.");
    CHECK(known_mistake(table, {one}).empty());
    CHECK(known_mistake(table, {one, other, red("misses", "t = 5")}).empty());
    CHECK(known_mistake(table, {one, red("touches", "t = 4")}).empty());
    CHECK(known_mistake(table, {green("crosses")}).empty());
    CHECK(known_mistake("", {one, other}).empty());
}

TEST_CASE("how a test ended, what it's about and what was accepted belong to what it saw; its file and line don't") {
    const std::vector<std::function<void(Verdict &)>> changes{
        [](Verdict &v) { v.kind = Outcome::crashed; }, [](Verdict &v) { v.label = "speed"; },
        [](Verdict &v) { v.call->answer = "t = 9"; }, [](Verdict &v) { v.accepted = {"dt < 0"}; }};
    const Verdict before = red("crosses", "t = 0.7");
    for (const auto &change : changes) {
        Verdict after = before;
        change(after);
        CHECK(seen_by(after) != seen_by(before));
    }
    Verdict elsewhere = before;
    elsewhere.file = "tests/07.cpp";
    elsewhere.line = 9;
    CHECK(seen_by(elsewhere) == seen_by(before));
}

TEST_CASE("rounding changes nothing about what a test saw, nor does the sign of a zero; six digits do") {
    const auto seen = [](const char *yours) { return seen_by(red("crosses", yours)); };
    CHECK(seen("(0.123456789, -0) m/s") == seen("(0.123456781, 0) m/s"));
    CHECK(seen("x = -3.48647101e-08 m") == seen("x = -3.48647093e-08 m"));
    CHECK(seen("1.2e-16") == seen("0"));
    CHECK(seen("(1, 2)") != seen("(1, -2)"));
    CHECK(seen("0.12345") != seen("0.12346"));
    CHECK(seen("nothing") != seen("0"));
}

TEST_CASE("tests that generate their input say nothing about a mistake") {
    const Verdict one = red("crosses", "t = 0.7"), other = red("touches", "t = 3");
    const std::string table = line({one, other}, "you swap them") + "7.2\tgenerated\trandom ones\n";
    CHECK(known_mistake(table, {one, other, red("random ones", "t = 0.123")}) == "you swap them.");
    CHECK(known_mistake(table, {red("random ones", "t = 0.123")}).empty());
}

TEST_CASE("a single failing test names a mistake only by infinity, NaN or a number other than 0, 1 and inputs") {
    for (const char *usual : {"t = 0", "t = 1", "t = 0.25", "t = 7", "nothing", "(4, 7) m"}) {
        INFO(usual);
        const Verdict one = red("crosses", usual);
        CHECK(known_mistake(line({one}, "you swap them"), {one}).empty());
    }
    for (const char *telling : {"t = 0.7", "(not a number, 0) m", "t = infinity", "-infinity s"}) {
        INFO(telling);
        const Verdict one = red("crosses", telling);
        CHECK(known_mistake(line({one}, "you swap them"), {one}) == "you swap them.");
    }
}

TEST_CASE("two mistakes that give the same are both named, three are not, and a question keeps its mark") {
    const std::vector<Verdict> failed{red("crosses", "t = 0.7"), red("touches", "t = 3")};
    const std::string one = line(failed, "you swap them"),
                      two = line(failed, "you begin at the end: where does it start?");
    CHECK(known_mistake(one + two, failed) == "you swap them, or when you begin at the end: where does it start?");
    CHECK(known_mistake(one + two + line(failed, "you guess"), failed).empty());
}

TEST_CASE("lost digits are told where all that failed has lost them, and not where one number of several is near") {
    const auto off = [](double part) {
        Verdict verdict = red("crosses", "t = 0.7");
        verdict.off = part;
        return verdict;
    };
    const std::string with = "const float half = 0.5f; // double", without = "const double half = 0.5; // no float";
    CHECK(lost_digits(with, {off(3e-8), green("misses"), off(1e-11)}).ends_with("Write double."));
    CHECK(lost_digits("const auto half = 1.5f;", {off(3e-8), off(3e-8)}).ends_with("Write double."));
    CHECK(lost_digits("const Eigen::Vector2f v;", {off(3e-8), off(3e-8)}).ends_with("Write double."));
    CHECK(lost_digits(without, {off(3e-8), off(3e-8)}).starts_with("Only the last digits are lost"));
    CHECK(lost_digits(with, {off(3e-8)}).ends_with("Write double.")); // the only test
    CHECK(lost_digits(with, {off(3e-8), green("misses")}).empty());
    CHECK(lost_digits(with, {off(3e-8), off(1e-4)}).empty());
    CHECK(lost_digits(with, {off(3e-8), red("touches", "t = 3")}).empty());
    CHECK(lost_digits(with, {off(1e-11), off(1e-12)}).empty());
    CHECK(lost_digits(with, {green("crosses"), green("misses")}).empty());
    Verdict accepts = off(3e-8);
    accepts.accepted = {"dt < 0"};
    CHECK(lost_digits(with, {off(3e-8), accepts}).empty());
}
