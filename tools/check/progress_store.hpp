#pragma once
// What the course remembers of the student, in <root>/.course/: how each exercise stood when it was last judged, how
// many rungs of its hints are open, each check of it, which bugs are solved, and copies of files that were replaced.
// All of it may be missing or broken: then nothing is remembered, and nothing fails.

#include "base/workspace.hpp"
#include "check/feedback.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// How an exercise stands: "passed", "not started", "needs 4.2 time_of_flight", or whatever the verdict called it.
struct ExerciseState {
    std::string number; ///< "7.2"
    std::string state;
};

/// What is remembered of one exercise.
struct Memory {
    std::string state;
    std::string file; ///< fingerprint of the text that was judged
    std::string when; ///< UTC, "2026-11-21T10:04:55Z"
};

/// Remembers how these exercises stand in a file with this text; others stay as they were.
/// A folder that cannot be written costs the memory, and a line on stderr, but not the command.
void remember(const Workspace &workspace, const Section &section, std::string_view text,
              const std::vector<ExerciseState> &states);

/// What is remembered of a section's exercises, by number.
std::map<std::string, Memory> recall(const Workspace &workspace, const Section &section);

/// Remembers how many rungs of an exercise's hints are open.
void remember_rungs(const Workspace &workspace, const std::string &number, int rungs);

/// The next of `rungs` rungs, counted from 0, which is open from now on; `rungs` if all have been.
/// Two commands at once get two different ones.
int take_rung(const Workspace &workspace, const std::string &number, int rungs);

/// How many rungs of hints are open, by the exercise's number.
std::map<std::string, int> open_rungs(const Workspace &workspace);

/// Remembers checks, each with the time as it is now.
void remember_attempts(const Workspace &workspace, const std::vector<Attempt> &attempts);

/// All that are remembered, of each exercise in the order in which they were made.
std::vector<Attempt> recall_attempts(const Workspace &workspace);

/// How far a hunt for a section's bugs has come.
struct Hunt {
    std::string begun;           ///< the name of the bug that is in the file; "" if none was written
    std::string written;         ///< fingerprint of that file as it was then
    std::set<std::string> found; ///< the names of those whose law was named
};
void remember_hunt(const Workspace &workspace, const Section &section, const Hunt &hunt);
Hunt recall_hunt(const Workspace &workspace, const Section &section);

/// Sixteen digits that change when a file's text does; "" if there is no file.
std::string fingerprint(const std::filesystem::path &file);

/// Copies a file of the student's to .course/kept/, under a name with date and time that no other copy has.
/// @return where the copy is
std::filesystem::path keep_copy(const Workspace &workspace, const std::filesystem::path &file);

/// The same for the file with the bug, if the student has changed it since it was written.
/// @return where the copy is; empty if there's nothing to keep
std::filesystem::path keep_copy_of_bug(const Workspace &workspace, const Section &section);

} // namespace course
