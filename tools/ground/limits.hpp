#pragma once
#include "ground/complaint.hpp"

#include <algorithm>
#include <string>
#include <sys/resource.h>

namespace course {

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
/// @throws MachineTrouble if no file may grow to what the largest ones here need
inline void require_room_in_files() {
    rlimit now{};
    if (::getrlimit(RLIMIT_FSIZE, &now) == 0 && now.rlim_max < (256u << 20))
        throw MachineTrouble{
            "this shell lets no file grow beyond " + std::to_string(now.rlim_max >> 10)
            + " KB: type `ulimit -f unlimited` where you set that limit, or use another shell. Nothing was "
              "judged"};
}

} // namespace course
