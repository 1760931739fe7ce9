#pragma once
// Running a section's tests with Catch2. harness.cpp has main, and calls section_main(): that of main.cpp in the program
// that checks a student's file, of author.cpp in the one for authors, and of own.cpp where a reader's own tests run.

#include "base/errors.hpp"
#include "judge/runner/session.hpp"

#include <catch2/catch_test_case_info.hpp>
#include <catch2/interfaces/catch_interfaces_reporter.hpp>

#include <functional>
#include <string>
#include <vector>

namespace course {

/// @return the exit code
/// @throws EnvironmentError  which main prints, and leaves with machine_trouble
int section_main(int argc, char **argv);

/// Describes a check that failed; empty where yours and expected say it.
using Explain = std::string (*)(const Catch::AssertionResult &);
extern Explain explain_failure;

/// "This doesn't hold: f(2) == 3, that is 4 == 3"
std::string what_does_not_hold(const Catch::AssertionResult &result);

/// The verdicts of this process, in the order in which tests ran.
extern std::vector<Verdict> verdicts;

/// Called with each of them, as soon as it's known.
extern std::function<void(const Verdict &)> on_verdict;

/// How many have passed: "8 of 13".
std::string passed_of_all();

/// A verdict on one of our answers, for us.
std::string in_words(const Verdict &verdict);

/// In the order of the file.
const std::vector<Catch::TestCaseInfo *> &all_tests();

std::string exercise_of(const Catch::TestCaseInfo &test);

/// Which of the tests a process runs: one of several equal parts, in the order of the file; of one exercise, or of all.
struct Part {
    unsigned index = 0, of = 1;
    std::string exercise = {};
    bool until_red = false;

    /// A single test, by place.
    static Part only(unsigned place) { return {place, static_cast<unsigned>(all_tests().size())}; }
};

/// Runs the tests of a part, each against another subject process.
/// @throws EnvironmentError if this machine keeps them from a verdict
void run_tests(Session &session, unsigned seed, const Part &part);

/// For a subject with known verdicts: the machine may be slow.
constexpr TimeLimits patient{.a_case = 60, .all = 600, .start = 60};

/// Runs tests here, against a subject with known verdicts, and prints them in words.
void print_verdicts(const std::string &subject, unsigned seed, const Part &part = {});

/// Whether there are verdicts, and all have passed.
bool all_passed();

/// Whether `cases` gives every generated case, instead of a hundredth.
extern bool all_cases;

} // namespace course
