#pragma once
#include <algorithm>
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

} // namespace course
