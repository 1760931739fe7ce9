#pragma once
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace course {

/// Of all files that a compiler has read, however the code named them, the first that lies in none of these folders.
/// @param rule     what the compiler has written for -MD: "student.o: /a/07.cpp /usr/include/math.h \"
/// @param file     the student's own
/// @param from     the folder that names without one are in: where the compiler ran
/// @param allowed  folders, with all below them
std::optional<std::filesystem::path> included_from_elsewhere(std::string_view rule, const std::filesystem::path &file,
                                                             const std::filesystem::path &from,
                                                             const std::vector<std::filesystem::path> &allowed);

} // namespace course
