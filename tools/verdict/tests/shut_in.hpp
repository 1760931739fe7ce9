#pragma once
// What the kernel keeps a student's process from: files, other processes, the network. No root is needed for it.
// Linux has it: Landlock since 5.13 (for files), seccomp since 3.5 (for calls). Elsewhere a subject has its limits only.

#include <filesystem>

namespace course {

/// What a process is kept from.
struct Protection {
    bool files = true;       ///< opening a file for writing, and reading any but the program and its libraries
    bool calls = true;       ///< starting processes, reaching others, the network, memory that outlives it
    bool privileges = true;  ///< what only root may do, where `course` is run by root
    bool descriptors = true; ///< files that were open when `course` was started
    bool limits = true;      ///< more memory, files and output than an exercise needs
};

/// What this kernel can do of it. With an address sanitizer none is taken, since that reads and starts things itself.
Protection protection_of_this_kernel();

/// Made before a fork; used between fork and exec.
class ShutIn {
  public:
    /// @param program  what will be started
    /// @param wanted   tests leave one out, to see what it is good for
    ShutIn(const std::filesystem::path &program, Protection wanted);
    ~ShutIn();
    ShutIn(const ShutIn &) = delete;
    ShutIn &operator=(const ShutIn &) = delete;

    /// From here on, and for every program that this process becomes.
    /// @return false if the kernel refuses what it says it can do; errno says why
    [[nodiscard]] bool shut() const;

  private:
    int rules = -1; ///< Landlock's; -1: none
    bool calls = false, privileges = true, descriptors = true;
};

} // namespace course
