#pragma once
// The same for our answers: a file with exercises in it defines "ours 7.4 move_and_bounce".
// COURSE_IF_CALLED: what is exported is what a page may call, which tools/play/link.cjs finds out.
#include "interface.hpp"

#ifdef COURSE_IF_CALLED
#define COURSE_EXPORT(name)
#else
#define COURSE_EXPORT(name) __attribute__((export_name(name)))
#endif

/// The same for one of our wrong answers, which the page may put in its place: "wrong 7.4 move_and_bounce".
#define COURSE_WRONG(name) __asm__("wrong " name) COURSE_EXPORT("wrong " name)

#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function __asm__("ours " number " " #function) COURSE_EXPORT("ours " number " " #function);     \
    namespace subject {
