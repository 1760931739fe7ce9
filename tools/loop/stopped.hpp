#pragma once
// What stopped a compiler or a linker that did not stop because of an error in the code: a limit, or the machine.

#include "ground/process.hpp"

#include <string>

namespace course {

/// What each process of a compiler or linker may use. A finished exercise takes a tenth of it.
constexpr Limits compiler_limits{
    .memory = std::size_t{2} << 30, .file_size = std::size_t{256} << 20, .processor_time = 10};

/// [s] For a compiler that sleeps, waiting for something that never comes, such as an included pipe without a writer.
constexpr double longest_wait = 10;
constexpr double longest_compilation = 120; ///< [s] in all, where nobody tells whether it sleeps

/// Whether a limit stopped it: then one sentence to the student, with what may be the cause; else an empty one.
/// @param said  what it printed, made plain
/// @throws MachineTrouble if the machine stopped it: a full disk, or a signal from outside
std::string stopped_by_a_limit(const Finished &finished, const std::string &said);

} // namespace course
