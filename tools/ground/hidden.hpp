#pragma once

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace course {

/// Whether this program is built with an address sanitizer, which reserves terabytes of addresses, reads
/// /proc/self/maps, and starts a program that finds names for addresses: nothing of that may be kept from it.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// From here on no process of the same user can read or change this one's memory, files or environment through /proc, or
/// trace it: a student's code runs beside it. (Root can; and the leak checker of a sanitizer must.)
inline void hide_from_other_processes() {
#ifdef __linux__
    if (!sanitized) ::prctl(PR_SET_DUMPABLE, 0);
#endif
}

} // namespace course
