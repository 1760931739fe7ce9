#pragma once
// From a student's file to verdicts: compile it, link it with the server, run the tests against it.

#include "ground/tree.hpp"
#include "loop/catalogue.hpp"
#include "verdict/shared/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace course {

struct Judgement {
    std::optional<Verdict> unbuilt;    ///< why the file does not compile or link; then no test ran
    std::vector<Verdict> verdicts;     ///< exactly one for each test that was asked for, in the order of its file
    std::vector<std::string> warnings; ///< of the compiler: "exercises/07_….cpp:12: unused variable 'x'"

    bool all_passed() const;
    bool our_fault() const; ///< a test has no verdict
};

/// How a file is judged.
struct Judging {
    unsigned seed = 2026;      ///< for generated values
    std::string exercise = {}; ///< "7.2": only its tests are run; empty: all
    bool with_ours = false;    ///< functions that it lacks are taken from our solution
};

/// Judges a file as a section's exercise, and keeps nothing. A process judges one file at a time; several processes may
/// judge at once, in one build folder.
/// @param file  a student's file, wherever it is
/// @throws Complaint if the file is not there, or the course cannot be built; MachineTrouble if the machine is in the way
Judgement judge(const Tree &tree, const Section &section, const std::filesystem::path &file, const Judging &how);

/// The same with the text of a file, under the name by which its author knows it.
Judgement judge(const Tree &tree, const Section &section, const std::string &name, const std::string &text,
                const Judging &how);

/// What the tests said, as one verdict for each test that there is: a test without one, or with two, has none, and so has
/// one that is not known.
/// @param said  a line of JSON for each verdict
std::vector<Verdict> one_for_each(const std::vector<KnownTest> &tests, const std::string &said);

} // namespace course
