#pragma once
// From a student's file to verdicts: compile it, link it with the server, run the tests against it.

#include "base/workspace.hpp"
#include "check/exercise.hpp"
#include "check/judgement.hpp"

#include <string>
#include <vector>

namespace course {

/// How a file is judged.
struct JudgeOptions {
    unsigned seed = 2026;               ///< for generated values
    std::string exercise = {};          ///< "7.2": only the tests of this one are run; empty: all
    std::vector<std::string> lent = {}; ///< functions that are taken from our solution if it lacks them, and no others
};

/// Judges a file as a section's exercise, and keeps nothing. A process judges one file at a time; several processes may
/// judge at once, in one build folder.
/// @param file  a student's file, wherever it is
/// @throws UserError if the file is not there, or the course cannot be built; EnvironmentError if the machine is in the way
JudgeResult judge(const Workspace &workspace, const Section &section, const std::filesystem::path &file,
                  const JudgeOptions &how);

/// The same with the text of a file, under the name that the author knows.
JudgeResult judge(const Workspace &workspace, const Section &section, const std::string &name, const std::string &text,
                  const JudgeOptions &how);

/// What the tests reported, as one verdict for each test that there is: a test without one, or with two, has none, and so has
/// one that is not known.
/// @param output  a line of JSON for each verdict
std::vector<Verdict> one_for_each(const std::vector<KnownTest> &tests, const std::string &output);

} // namespace course
