#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The whole file, byte for byte.
/// @throws Complaint naming the path, if it cannot be read.
std::string read_file(const std::filesystem::path &path);

/// The files that stand in the folder itself, sorted, and none if there is no such folder.
/// @param end    what their names end with
/// @param start  what they begin with
std::vector<std::filesystem::path> files_in(const std::filesystem::path &folder, std::string_view end = "",
                                            std::string_view start = "");

/// Replaces the file, or makes it and its folders: at any moment either the whole old file is there or the whole new one.
/// A file that has this text already is left alone, with its date. The next draft is written
/// over one that a kill has left in the folder.
/// @return whether the file changed
/// @throws Complaint in one sentence, if the disk is full or the folder is not ours to write.
bool write_file(const std::filesystem::path &path, std::string_view text);

/// A folder of its own, gone in the end with all that is in it.
struct Scratch {
    /// @param beginning  of its path
    explicit Scratch(const std::filesystem::path &beginning);
    ~Scratch();
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    std::filesystem::path folder; ///< empty if it cannot be made
    int error = 0;                ///< why not, as errno has it
};

} // namespace course
