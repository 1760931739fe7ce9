#pragma once
// What else a compiler or a linker did than to find errors in the code: a limit or the machine stopped it, or it has read
// what it should not.

#include "base/process.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// What each process of a compiler or linker may use. A finished exercise takes a tenth of it.
constexpr Limits compiler_limits{
    .memory = std::size_t{2} << 30, .file_size = std::size_t{256} << 20, .processor_time = 10};

/// [s] For a compiler that sleeps, waiting for something that never comes, such as an included pipe without a writer.
constexpr double longest_wait = 10;
constexpr double longest_compilation = 120; ///< [s] in all, where nobody tells whether it sleeps

/// Whether a compiler or linker that failed says where in the code something is wrong. If not, the words it printed don't
/// tell whose fault it is, since a student can write them, too: then the machine is asked, by a file that's known to be good.
/// @param output  what it printed, made plain
bool is_about_the_code(const Finished &finished, const std::string &output);

/// Whether a limit stopped it: then one sentence to the student, with what may be the cause; else an empty one.
std::string stopped_by_a_limit(const Finished &finished, const std::string &output);

/// Whether a step that ran out of disk or memory could have had as much as its limits allow.
/// @param folder  where it wrote, when nothing that it has left takes room
/// @throws EnvironmentError if not
void require_room(const std::string &output, const std::filesystem::path &folder);

/// What's in the way of a file that's known to be good.
std::string machine_trouble_in(const Finished &finished, const std::string &output);

/// Of all files that a compiler has read, however the code named them, the first that lies in none of these folders.
/// @param rule     what the compiler has written for -MD: "student.o: /a/07.cpp /usr/include/math.h \"
/// @param file     the student's own
/// @param from     the folder that names without one are in: where the compiler ran
/// @param allowed  folders, with all below them
std::optional<std::filesystem::path> included_from_elsewhere(std::string_view rule, const std::filesystem::path &file,
                                                             const std::filesystem::path &from,
                                                             const std::vector<std::filesystem::path> &allowed);

} // namespace course
