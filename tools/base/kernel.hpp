#pragma once
// What the kernel tells of processes that were started, lets them use, and keeps from others. Systems without /proc know
// of no children, and of nobody asleep.

#include "base/errors.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/types.h>
#include <vector>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace course {

/// Processes whose parent this one is by now.
inline std::vector<pid_t> children_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream list{"/proc/" + id + "/task/" + id + "/children"};
    std::vector<pid_t> all;
    for (pid_t child = 0; list >> child;) all.push_back(child);
    return all;
}

/// Whether it neither computes nor waits for a core or a disk, at this moment.
inline bool is_asleep(pid_t process) {
    std::string line;
    std::getline(std::ifstream{"/proc/" + std::to_string(process) + "/stat"}, line);
    const std::size_t name_ends = line.rfind(") "); // see proc(5)
    return name_ends != line.npos && std::string_view{"STt"}.find(line[name_ends + 2]) != std::string_view::npos;
}

/// What this process, and whatever it starts, may use of something: a signal comes at `soft`, and the end at `hard`. An
/// earlier limit that is stricter stays. Safe between fork and exec.
inline void limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard) {
    rlimit now{};
    if (::getrlimit(what, &now) != 0) return;
    now.rlim_max = std::min(now.rlim_max, hard);
    now.rlim_cur = std::min(now.rlim_max, soft);
    ::setrlimit(what, &now);
}
inline void limit(decltype(RLIMIT_CPU) what, rlim_t most) { limit(what, most, most); }

/// Before anything is compiled: a program that is cut off by the shell's limit would be called somebody's mistake.
/// @throws EnvironmentError if no file may grow to what the largest ones here need
inline void require_room_in_files() {
    rlimit now{};
    if (::getrlimit(RLIMIT_FSIZE, &now) == 0 && now.rlim_max < (256u << 20))
        throw EnvironmentError{
            "this shell lets no file grow beyond " + std::to_string(now.rlim_max >> 10)
            + " KB: type `ulimit -f unlimited` where you set that limit, or use another shell. Nothing was "
              "judged"};
}

/// Whether this program is built with an address sanitizer, which reserves terabytes of addresses, reads
/// /proc/self/maps, and starts a program that finds names for addresses: nothing of that may be kept from it.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// This process gets a signal as soon as the parent ends, however that does. Safe between fork and exec.
inline void end_with_parent([[maybe_unused]] int signal) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, signal);
#endif
}

/// From here on no process of the same user can read or change this one's memory, files or environment through /proc, or
/// trace it: a student's code runs beside it. (Root can; and the leak checker of a sanitizer must.)
inline void hide_from_other_processes() {
#ifdef __linux__
    if (!sanitized) ::prctl(PR_SET_DUMPABLE, 0);
#endif
}

} // namespace course
