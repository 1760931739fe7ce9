#pragma once
#include <filesystem>
#include <string>

namespace course {

/// All of a file with answers: a regular file of at most 1 MB, whatever it is called.
/// @throws UserError if it is anything else, with what it is: nothing waits for a pipe, or reads a device to its end.
std::string read_answer(const std::filesystem::path &file);

} // namespace course
