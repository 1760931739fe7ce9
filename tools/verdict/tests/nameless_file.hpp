#pragma once
#include <string>
#include <string_view>

namespace course {

/// A file that no other process can find, as it has no name, and that goes with this object. A program that is started
/// does not inherit it.
class NamelessFile {
  public:
    /// @throws MachineTrouble if the machine has no room for one
    NamelessFile();
    ~NamelessFile();
    NamelessFile(const NamelessFile &) = delete;
    NamelessFile &operator=(const NamelessFile &) = delete;

    int descriptor() const { return file; }
    void append(std::string_view text);       ///< @throws MachineTrouble if there is no room
    std::string text(std::size_t most) const; ///< its first `most` bytes

  private:
    int file;
};

} // namespace course
