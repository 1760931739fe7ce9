#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Waits for the reader to save one of some files.
class FileWatch {
  public:
    /// Saves count from here on.
    explicit FileWatch(std::vector<std::filesystem::path> files);

    /// Returns at the next save, or at Enter, for those whose disk tells no dates.
    /// @return false once q is typed
    bool wait();

  private:
    std::string look() const;

    std::vector<std::filesystem::path> files;
    std::string state; ///< dates and sizes at the last look; "" if a file was not there
    bool keys = true;  ///< whether the keyboard has more to read
};

} // namespace course
