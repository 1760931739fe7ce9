#pragma once
// Zip archives that anybody may have made: read with caps on everything; and written, the same bytes for the same files.

#include "base/errors.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace course {

inline constexpr std::size_t most_entries = 20'000; ///< more than any class hands in

/// Why nothing of such a name is touched: "leads out of its folder"; empty if it's harmless.
std::string unsafe_name(std::string_view name);

/// A name without marks of direction, so that readers see what's there; other characters that can't be displayed become question marks.
std::string without_marks(std::string_view name);

/// There is more of it than was asked for.
struct TooLarge : UserError {
    using UserError::UserError;
};

class Archive {
  public:
    /// A file in it, as the directory has it.
    struct Entry {
        std::string name;        ///< as it stands there, with slashes, and `without_marks`
        std::uint64_t size = 0;  ///< [bytes] unpacked, as the archive claims
        std::string unsafe;      ///< why nothing of it may be read: "is a link", "leads out of its folder"; else empty
        std::uint64_t place = 0; ///< in the archive's directory
    };

    /// @throws UserError if it isn't there, no zip, or has more entries than any class hands in
    explicit Archive(const std::filesystem::path &file);
    ~Archive();
    Archive(const Archive &) = delete;
    Archive &operator=(const Archive &) = delete;

    const std::vector<Entry> &entries() const { return all; } ///< without folders
    /// The entry's bytes, but never more than `most`, whatever size the archive claims.
    /// @throws TooLarge, or another UserError if it's unsafe or broken
    std::string read(const Entry &entry, std::uint64_t most) const;

  private:
    struct Opened;
    std::unique_ptr<Opened> opened;
    std::vector<Entry> all;
};

/// Writes a zip with these files, by name: the same bytes for the same files, whenever.
void write_archive(const std::filesystem::path &file, const std::vector<std::pair<std::string, std::string>> &files);

} // namespace course
