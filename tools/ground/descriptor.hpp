#pragma once
#include <unistd.h>
#include <utility>

namespace course {

/// The number of an open file, which is closed with this object; -1: none.
class Descriptor {
  public:
    Descriptor(int number = -1) : file{number} {}
    Descriptor(Descriptor &&other) noexcept : file{std::exchange(other.file, -1)} {}
    Descriptor &operator=(Descriptor &&other) noexcept { return std::swap(file, other.file), *this; }
    ~Descriptor() { close(); }
    operator int() const { return file; }
    void close() {
        if (file >= 0) ::close(std::exchange(file, -1));
    }

  private:
    int file;
};

} // namespace course
