#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The whole file, byte for byte.
/// @throws UserError naming the path, if it cannot be read.
std::string read_file(const std::filesystem::path &path);

/// The files that stand in the folder itself, sorted, and none if there is no such folder.
/// @param end    what their names end with
/// @param start  what they begin with
std::vector<std::filesystem::path> files_in(const std::filesystem::path &folder, std::string_view end = "",
                                            std::string_view start = "");

/// Replaces the file, or makes it and the folders above it: at any moment either the whole old file is there or the
/// whole new one. A file that has this text already is left alone, with the same date.
/// @return whether the file changed
/// @throws UserError in one sentence, if the disk is full or the folder is not ours to write.
bool write_file(const std::filesystem::path &path, std::string_view text);

/// TMPDIR, or /tmp. @throws UserError if it's no folder
std::filesystem::path temporary_files();

/// A temporary folder, removed in the end with all that is in it.
struct Scratch {
    /// @param beginning  of the path
    explicit Scratch(const std::filesystem::path &beginning);
    ~Scratch();
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    std::filesystem::path folder; ///< empty if it cannot be made
    int error = 0;                ///< why not, as errno has it
};

} // namespace course
