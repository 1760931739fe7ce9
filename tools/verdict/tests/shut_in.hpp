#pragma once
// What the kernel keeps a process from that runs a student's code, or compiles it: files, other processes, the network.
// No root is needed for it. Linux has it: Landlock since 5.13 (for files), seccomp since 3.5 (for calls). Elsewhere such a
// process has its limits only.

#include "ground/descriptor.hpp"

#include <filesystem>
#include <vector>

namespace course {

/// What a process is kept from.
struct Protection {
    bool files = true;       ///< opening any file but those in its Places
    bool calls = true;       ///< starting processes, reaching others, the network, memory that outlives it
    bool privileges = true;  ///< what only root may do, where `course` is run by root
    bool descriptors = true; ///< files that were open when `course` was started
    bool limits = true;      ///< more memory, files and output than an exercise needs
};

/// What this kernel can do of it. With an address sanitizer none is taken, since that reads and starts things itself.
Protection protection_of_this_kernel();

/// What a process may open: files, or folders with all below them.
struct Places {
    std::vector<std::filesystem::path> readable, writable; ///< what is readable may be run, too
};

/// What a program needs that is linked as we are: its own file, and our libraries.
Places places_of(const std::filesystem::path &program);

/// Where the system's own programs and libraries are, which anybody may read and run.
std::vector<std::filesystem::path> places_of_system();

/// Made before a fork; used between fork and exec.
class ShutIn {
  public:
    /// @param wanted  tests leave one out, to see what it is good for
    ShutIn(const Places &places, Protection wanted);

    /// From here on, and for every program that this process becomes.
    /// @param last  the highest of its own descriptors: those above are closed when the program starts
    /// @return false if the kernel refuses what it says it can do; errno says why
    [[nodiscard]] bool shut(int last) const;

  private:
    Descriptor rules; ///< Landlock's; none elsewhere
    bool calls = false, privileges = true, descriptors = true;
};

} // namespace course
