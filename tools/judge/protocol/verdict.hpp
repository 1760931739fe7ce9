#pragma once
// The verdict on one test case: the same at a student's desk, in CI and in a grader.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

enum class Outcome {
    passed,
    wrong,
    not_started,
    empty,
    unreadable, ///< no text in UTF-8
    does_not_compile,
    does_not_link,
    missing,
    threw,
    crashed,
    no_memory,
    too_long,
    left,
    not_a_number,
    out_of_turn,
    left_process,
    printed_too_much,
    no_verdict, ///< the test itself is at fault: it asserted nothing, was skipped, or died
};

/// "wrong", "not started": how a kind is named in lists and in files for machines.
std::string_view name_of(Outcome kind);

/// The call that led to a verdict.
struct Call {
    std::string function;
    std::vector<std::string> arguments; ///< "motion = {from (4, 7) m, to (16, 3) m}"
    int before = 0;                     ///< calls of the same case that came before it
    std::string answer;                 ///< all of what came back; empty if nothing did
};

struct Verdict {
    std::string exercise = {}; ///< "7.2"
    std::string test = {};     ///< the claim
    Outcome kind = Outcome::passed;
    std::string sentence = {}; ///< what happened, to the student; empty where yours and expected say it
    std::optional<Call> call = {};
    std::vector<std::string> accepted = {}; ///< inputs to be refused: "dt is negative", "motion.start.x = infinity"
    std::string label = {}; ///< what yours and expected are about, where that is not the answer itself: "speed along x"
    std::string yours = {}, expected = {}, tolerance = {};
    std::string whole = {}; ///< the whole struct that is expected, where yours and expected are a field of it
    std::string since = {}; ///< how what is expected is worked out: "1600 / 64 = 25 N"
    double off = 1;         ///< relative error of a number: 1e-7 if seven digits are right
    std::string file = {};  ///< of the check that failed, or of the error
    int line = 0;
    std::vector<std::string> printed = {}; ///< the first lines of what the case printed
    std::size_t printed_more = 0;          ///< lines that were left out
    std::string needs = {}; ///< the exercise that it calls, and that is not started: "4.2 time_of_flight"

    bool passed() const { return kind == Outcome::passed; }
};

/// A verdict as a line of JSON, and back: nothing if the line is none, or half of one.
std::string to_line(const Verdict &verdict);
std::optional<Verdict> from_line(std::string_view line);

/// What a student reads of a case that is not passed: some lines, each indented by `indent` blanks.
std::string explain(const Verdict &verdict, int indent);

/// The first `lines` lines of what a program printed, each at most 160 characters, without control characters
/// or broken UTF-8; and how many lines there were beyond.
std::pair<std::vector<std::string>, std::size_t> tidy(std::string_view printed, std::size_t lines = 20);

/// How a student's process ended, by the signal that ended it: "crashed: it divided a whole number by zero".
std::string meaning_of_signal(int signal);

/// What a failed check of the standard library or of Eigen means, by what it printed; empty if none did.
std::string meaning_of_assertion(std::string_view printed);

} // namespace course
