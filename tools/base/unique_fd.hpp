#pragma once
#include <unistd.h>
#include <utility>

namespace course {

/// The number of an open file, which is closed with this object; -1: none.
class UniqueFd {
  public:
    UniqueFd(int number = -1) : file{number} {}
    UniqueFd(UniqueFd &&other) noexcept : file{std::exchange(other.file, -1)} {}
    UniqueFd &operator=(UniqueFd &&other) noexcept { return std::swap(file, other.file), *this; }
    ~UniqueFd() { close(); }
    operator int() const { return file; }
    void close() {
        if (file >= 0) ::close(std::exchange(file, -1));
    }

  private:
    int file;
};

} // namespace course
