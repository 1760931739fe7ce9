#pragma once
// A reader's own tests of a section, and what they make of answers of which we know whether they're right.

#include "base/workspace.hpp"
#include "judge/protocol/verdict.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace course {

/// What the file of a section's own tests holds before anything is written: one empty test.
std::string empty_own_tests(const Workspace &workspace, const Section &section);

/// A test of the reader's.
struct OwnTest {
    std::string name;
    int line = 0;                   ///< of the file
    std::vector<std::string> calls; ///< the exercises that it calls: "2.1"
    Verdict verdict;                ///< on our solution
    bool sound = false;             ///< every right answer passes it
};

/// A test that our solution passes, and another right answer doesn't.
struct Refusal {
    std::string right; ///< what is special about this answer
    Verdict verdict;
};

/// A mistake in an exercise that a sound test calls.
struct KnownMistake {
    std::string what; ///< "you return the net force itself"
    bool caught = false;
};

struct OwnJudgement {
    std::optional<Verdict> unbuilt; ///< why the file doesn't compile or link; then no test ran
    std::vector<std::string> warnings;
    std::vector<OwnTest> tests;
    std::vector<Refusal> refusals;
    std::map<std::string, int> right;                          ///< of each exercise that a test calls: right answers
    std::map<std::string, std::vector<KnownMistake>> mistakes; ///< of each exercise that a sound test calls
};

/// @throws UserError if this edition of the course has no answers to run tests against: none for readers to see
void require_answers(const Workspace &workspace, const Section &section);

/// Whether our right and wrong answers are compiled: the first time, that takes a while.
bool are_answers_built(const Workspace &workspace, const Section &section);

/// Compiles the tests, and the answers where these are older than their sources, and runs the tests, shut in.
/// @throws UserError if the course can't be built; EnvironmentError if the machine is in the way
OwnJudgement judge_own_tests(const Workspace &workspace, const Section &section);

} // namespace course
