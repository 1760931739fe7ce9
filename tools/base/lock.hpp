#pragma once
#include "base/unique_fd.hpp"
#include "base/workspace.hpp"

namespace course {

/// Held while a command writes into the build folder, so that two of them never build at once.
/// The same lock as the `course` script's, $BUILD/.lock, where the holder writes who it is. What a holder starts may
/// build as well: it finds COURSE_LOCKED in the environment, and takes no other lock.
class Lock {
  public:
    /// Waits for the other one, and says so on stderr if that takes longer than a moment.
    /// @throws UserError if the build folder cannot be written.
    explicit Lock(const Workspace &workspace);
    ~Lock();

  private:
    UniqueFd file; ///< none: the process that started us holds the lock
};

/// Held for the moment in which a file is read, changed and written back, so that two commands at once lose nothing.
/// Where `file` cannot be made, nothing is held.
[[nodiscard]] UniqueFd short_lock(const std::filesystem::path &file);

} // namespace course
