#pragma once
// What a student's file is compiled and linked with, as CMake left it in course.json.

#include "base/workspace.hpp"
#include "judge/runner/sandbox.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace course {

struct Compiler {
    std::string program;
    std::vector<std::string> flags, precompiled; ///< the last: what puts the precompiled header before a file

    /// The command that compiles a file of this section.
    std::vector<std::string> command(const Workspace &workspace, const Section &section,
                                     const std::filesystem::path &file, const std::filesystem::path &object) const;
};

struct BuildConfig {
    Compiler compiler;             ///< of the whole course
    std::optional<Compiler> quick; ///< Clang beside GCC, at -O0, with its templates compiled beforehand: see `judge`
    std::string nm, objcopy, node;
    std::vector<std::string> link, quick_link; ///< the last: also, for what the quick compiler has compiled
    std::filesystem::path server, missing;
    std::filesystem::path ours; ///< our functions, each of which gives way to one of the same name; empty in a handout
    std::vector<std::filesystem::path> includes; ///< what a student's file may include: files, or folders with headers
    std::vector<std::string>
        earlier; ///< objects: the solutions of the sections that this one builds on; in a handout, the student's
    bool plays_yours = false; ///< whether its demo plays the student's functions of those, too
};

/// @throws UserError if the course is not built yet, or course.json is broken
BuildConfig build_config(const Workspace &workspace, const Section &section);

/// What a compiler, a linker or nm opens: what comes with it, and the files that this command names.
AllowedPaths allowed_paths(const std::vector<std::string> &command);

/// Builds what is older than the course's files: ninja is asked only then, for it takes longer to say "no work".
/// @throws UserError if that fails
void bring_up_to_date(const Workspace &workspace, const Section &section, const BuildConfig &config);

/// The same for a section of which nothing is built yet, as where only this one is wanted: says so, and builds it alone.
void build_if_missing(const Workspace &workspace, const Section &section);

} // namespace course
