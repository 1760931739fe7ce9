#pragma once
// Read before a section's header, says what its COURSE_EXERCISE means to a file that calls exercises in a page. There each
// exercise exists twice, ours and yours, and a demo calls neither: it imports "7.4 move_and_bounce" from the page, which
// passes the call on.
#include "interface.hpp"

#undef COURSE_EXERCISE // it meant nothing in the headers of earlier sections
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function __attribute__((import_module("exercises"), import_name(number " " #function)));        \
    namespace subject {
