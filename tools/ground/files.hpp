#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// The whole file, byte for byte.
/// @throws Complaint naming the path, if it cannot be read.
std::string read_file(const std::filesystem::path &path);

/// Replaces the file, or makes it and its folders: at any moment either the whole old file is there or the whole new one.
/// A file that has this text already is left alone, with its date. A draft that a kill leaves in the folder is removed
/// when the file is written next.
/// @return whether the file changed
/// @throws Complaint in one sentence, if the disk is full or the folder is not ours to write.
bool write_file(const std::filesystem::path &path, std::string_view text);

} // namespace course
