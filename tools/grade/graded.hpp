#pragma once
// What comes out for a class: each student's verdicts and points.

#include "check/catalogue.hpp"
#include "check/which_tests.hpp"
#include "grade/submissions.hpp"
#include "judge/protocol/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace course {

/// One exercise of one student.
struct GradedExercise {
    Exercise exercise;
    double possible = 0; ///< points
    double earned = 0;
    std::size_t passed = 0, counted = 0; ///< of the tests, without those that are void
    std::size_t baseline = 0;            ///< how many of those an answer passes that computes nothing
    std::vector<Verdict> verdicts;       ///< one for each test, in the order of the file
    std::optional<Verdict> unbuilt;      ///< why this function doesn't compile: the rest was judged without it
    std::string consequence_of;          ///< "5.4": it's right, but calls this one, which isn't; else empty
    std::string mistake;                 ///< what the student did, if that is known: "you leave the ends open."

    bool all_passed() const { return !unbuilt && counted > 0 && passed == counted; }
};

struct Graded {
    Submission submission;
    std::vector<GradedExercise> exercises; ///< empty if nothing was judged
    std::vector<Verdict> taken_out;        ///< as in Outcomes
    std::optional<Verdict> unbuilt;        ///< why the file as a whole doesn't compile, or is none
    std::string our_trouble;              ///< why there is no verdict that counts: the grader's fault, or the machine's
    int days_late = 0;                    ///< started ones that cost points
    double taken_off = 0;                 ///< for them
    std::optional<double> overridden;     ///< points that the instructor has set instead
    std::string why;                      ///< the instructor's reason
    bool left_blank = false;              ///< there's no file to judge, and the instructor gives no 0 for that
    std::string file_hash;                ///< SHA-256 of what was judged, 64 digits
    std::optional<WhichTests> began_with; ///< the tests that the file was handed out with, if they're other ones

    double judged() const; ///< by tests and lateness
    double earned() const; ///< the same, or what the instructor has set
    double possible() const;
};

/// Whether there are points to show, or to count with: by a verdict, or by the instructor.
inline bool has_grade(const Graded &student) {
    return student.overridden || (student.our_trouble.empty() && !student.left_blank);
}

/// All of a class, with what was agreed on.
struct GradedClass {
    Section section;
    Platform platform = Platform::folder;
    std::string version, tests_hash;     ///< of the course; of the tests, 64 digits
    std::vector<std::string> void_tests; ///< by name
    std::vector<Graded> students;        ///< by id, as Submissions has them
    std::vector<KnownTest> tests;        ///< of the section, in the order of the file
    unsigned seed = 2026;                ///< of the values that tests draw
    std::string warning = {};            ///< what wasn't shut in while this was judged
};

} // namespace course
