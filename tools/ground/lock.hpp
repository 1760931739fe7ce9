#pragma once
#include "ground/descriptor.hpp"
#include "ground/tree.hpp"

namespace course {

/// Held while a command writes into the build folder, so that two of them never build at once.
/// The same lock as the `course` script's, $BUILD/.lock, where its holder writes who it is. What a holder starts may
/// build as well: it finds COURSE_LOCKED in the environment, and takes none of its own.
class Lock {
  public:
    /// Waits for the other one, and says so on stderr if that takes longer than a moment.
    /// @throws Complaint if the build folder cannot be written.
    explicit Lock(const Tree &tree);
    ~Lock();

  private:
    Descriptor file; ///< none: the process that started us holds the lock
};

/// Held for the moment in which a file is read, changed and written back, so that two commands at once lose nothing.
/// Where `file` cannot be made, nothing is held.
[[nodiscard]] Descriptor short_lock(const std::filesystem::path &file);

} // namespace course
