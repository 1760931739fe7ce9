#pragma once
// What the kernel keeps a process from that runs a student's code, or compiles it: files, other processes, the network.
// No root is needed for it. Linux has it: Landlock since 5.13 (for files), seccomp since 3.5 (for calls). Elsewhere such a
// process has only limits.

#include "base/unique_fd.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// What a process is kept from.
struct Protection {
    bool files = true;       ///< opening any file but those in AllowedPaths
    bool calls = true;       ///< starting processes, reaching others, the network, memory that outlives it
    bool privileges = true;  ///< what only root may do, where `course` is run by root
    bool descriptors = true; ///< files that were open when `course` was started
    bool limits = true;      ///< more memory, files and output than an exercise needs
};

/// What this kernel can do of it. With an address sanitizer none is taken, since that reads and starts things itself.
Protection protection_of_this_kernel();

/// Of Landlock; 0 if this kernel has none.
int landlock_version();

/// A sentence on what this kernel lacks of Landlock and seccomp, for whoever judges others' code; empty if nothing.
std::string warning_of_this_kernel();

/// What a process may open: files, or folders with all below them.
struct AllowedPaths {
    std::vector<std::filesystem::path> readable, writable; ///< what is readable may be run, too
};

/// What a program needs that is linked as we are: the file, and our libraries.
AllowedPaths allowed_paths(const std::filesystem::path &program);

/// Where the system's own programs and libraries are, which anybody may read and run.
std::vector<std::filesystem::path> system_paths();

/// Made before a fork; used between fork and exec.
class Sandbox {
  public:
    /// @param protection  tests leave one out, to see what it is good for
    Sandbox(const AllowedPaths &places, Protection protection);

    /// From here on, and for every program that this process becomes.
    /// @param last  the highest descriptor that it may keep: those above are closed when the program starts
    /// @return false if the kernel refuses what it says it can do; errno says why
    [[nodiscard]] bool shut(int last) const;

  private:
    UniqueFd rules; ///< Landlock's; none elsewhere
    bool calls = false, privileges = true, descriptors = true;
};

} // namespace course
