#pragma once
// Read before a section's header, gives COURSE_EXERCISE its meaning in a page. There each exercise exists twice, ours
// and yours, and a demo calls neither: it imports "7.4 move_and_bounce" from the page, which passes the call on.
// COURSE_CALLS: this file calls exercises. COURSE_ANSWERS "ours": it defines them, as "ours 7.4 move_and_bounce".
#include "interface.hpp"

#undef COURSE_EXERCISE // it meant nothing in the headers of earlier sections
#ifdef COURSE_CALLS
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function __attribute__((import_module("exercises"), import_name(number " " #function)));        \
    namespace subject {
#else
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function __asm__(COURSE_ANSWERS " " number " " #function)                                       \
        __attribute__((export_name(COURSE_ANSWERS " " number " " #function)));                                         \
    namespace subject {
#endif
