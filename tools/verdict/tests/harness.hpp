#pragma once
// Running a section's tests, shared by harness.cpp, which has the main, and own.cpp, which judges a reader's tests.

#include "verdict/tests/session.hpp"

#include <catch2/catch_test_case_info.hpp>
#include <catch2/interfaces/catch_interfaces_reporter.hpp>

#include <functional>
#include <string>
#include <vector>

namespace course {

/// What is said of a check that failed; empty where yours and expected say it.
using InWords = std::string (*)(const Catch::AssertionResult &);
extern InWords explain_failure;

/// "This doesn't hold: f(2) == 3, that is 4 == 3"
std::string what_does_not_hold(const Catch::AssertionResult &result);

/// The verdicts of this process, in the order in which its tests ran.
extern std::vector<Verdict> verdicts;

/// In the order of the file.
const std::vector<Catch::TestCaseInfo *> &all_tests();

/// Which of the tests a process runs: one of several equal parts, in the order of the file; of one exercise, or of all.
struct Part {
    unsigned index = 0, of = 1;
    std::string exercise = {};
    bool until_red = false;
};

/// Runs the tests of a part, each against a subject of its own.
void run_tests(Session &here, unsigned seed, const Part &part);

/// What one of several processes does with an item of a list; it tells of it in lines, where no subject can reach them.
using Job = std::function<void(unsigned item, NamelessFile &lines)>;

/// Does a job for each of so many items, in as many processes as there are cores, and adds what they tell.
/// @return all_well, or machine_trouble if the machine kept one of them from its end
int share_all(std::size_t count, const Job &job, std::vector<std::string> &told);

/// An answer of tests/wrong or tests/right, as tests/answers/generate.cpp lists it.
struct Answer {
    std::string name, exercise, rest; ///< rest: how it's to be judged, or what a reader did who gave it

    bool is_wrong() const { return name.starts_with("wrong_"); }
};
std::vector<Answer> read_list(const std::string &file);

/// Prints, in lines of JSON, what a reader's own tests say of our solution, of the right answers and of the wrong ones
/// that this file lists: see own.cpp.
/// @return the exit code
int judge_own_tests(const std::string &subject, const std::string &claims);

} // namespace course
