#pragma once
// A section's program, the reference's or the student's: where it is, building it, running it, and what it did, in one
// sentence. `course run` and `course plot` share this.

#include "base/process.hpp"
#include "base/workspace.hpp"

#include <filesystem>
#include <string>

namespace course {

/// Which functions a section's program is linked with.
enum class Whose { reference, student };

/// Where the reference's program writes traces, one `NN_slug_<figure>.tsv` for each figure; without a solution, where
/// the published ones are.
std::filesystem::path reference_traces(const Workspace &workspace, const Section &section);

/// The same for the student's program; it is emptied before each run.
std::filesystem::path student_traces(const Workspace &workspace, const Section &section);

/// Where the built program is.
std::filesystem::path program_binary(const Workspace &workspace, const Section &section, Whose owner);

/// What became of a program that was built and run.
struct Ran {
    bool started = false; ///< false if it could not be built
    Finished finished;    ///< exit code and what it printed, if it was started
    std::string trouble;  ///< one sentence with the remedy; empty if all went well
};

constexpr int unknown_part = 2; ///< what a program exits with if it has no part of that name, or cannot write

/// The command that runs a section's program, or one part of it, with the traces in that folder.
std::vector<std::string> program_command(const std::filesystem::path &program, const std::string &part,
                                         const std::filesystem::path &traces);

/// Builds the program where sources are newer and runs it, or one part of it; the student's is shut in, with limits,
/// and for at most `deadline` [s] of computing: it may write traces, and nothing else.
/// What a student's file does (not compile, hang, crash, stop early) is reported in `trouble`. The caller holds the Lock.
/// @throws UserError if there is no such part, if the exercise is not there, if a folder cannot be written, or if cmake
/// is missing.
Ran run_program(const Workspace &workspace, const Section &section, Whose owner, const std::filesystem::path &traces,
                const std::string &part = "", double deadline = 10);

/// What the program printed of the part that writes this trace: "not started: ..." or "error: ...", without the part's
/// name; "" if it printed nothing.
std::string trace_message(const Finished &finished, const std::string &trace);

/// Whether nothing kept this program from ending well but functions that are not started.
bool is_only_unfinished(const Finished &finished);

/// The last line of a text that is not blank.
std::string last_line(const std::string &text);

/// What keeps a student's file from being compiled, by what the build printed: in the words of `course check`.
std::string student_error(const Workspace &workspace, const Section &section, const std::filesystem::path &file,
                          const std::string &printed);

} // namespace course
