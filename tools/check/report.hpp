#pragma once
// What a student reads of a check, with colours: from data alone, so that a terminal and a page say the same.

#include "check/exercise.hpp"
#include "check/judgement.hpp"
#include "check/reader.hpp"

#include <string>
#include <vector>

namespace course {

/// The verdicts on one exercise.
struct ExerciseResult {
    Exercise exercise;
    std::vector<Verdict> verdicts;

    const Verdict *first_failure() const; ///< none if all passed
    const Verdict *first_open() const;    ///< the first that says the exercise isn't started
    /// Not started as long as any call says so: a stub that refuses bad input passes some tests as it is.
    Outcome state() const;
    /// How far it is from done: "wrong", "not started", "needs 4.2 time_of_flight". This is remembered, too.
    std::string standing() const;
};

/// A section's file that was checked, and what came of it.
struct Checked {
    std::string name; ///< of the file, to its author: "exercises/07_….cpp"
    std::string text; ///< of the file
    JudgeResult judgement;
    std::vector<Exercise> exercises; ///< all of the section
    std::string only = {};           ///< "7.2": the exercise that was asked for; empty: all
    std::string mistakes = {};       ///< what's known of them: tests/NN_slug/mistakes.tsv

    /// Of those that were asked for.
    std::vector<ExerciseResult> results() const;
    /// Whether all tests failed for one reason, which has nothing to do with any of them: the code never got as far.
    bool never_started() const;
};

/// How a report is told.
struct ReportOptions {
    bool verbose = false; ///< every test, every failure whole, and all warnings
    bool picture = false; ///< say how to see a failure drawn, where it can be
    Reader reader = Reader::terminal;
};

/// Warnings, then why the file isn't built, or each exercise in one line, with what's wrong below it.
std::string explain(const Checked &checked, const ReportOptions &how);

/// Where the compiler or the linker stopped in this file, or what the compiler warns of.
std::string explain_unbuilt(const Verdict &verdict, const std::string &name);
std::string explain_warnings(const std::vector<std::string> &warnings, const ReportOptions &how);

/// What to do next in a section.
/// @param next       the exercise to go on with; none if all are passed
/// @param number     of the section
std::string explain_next(const Standing *next, const std::string &number);

} // namespace course
