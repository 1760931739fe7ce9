#pragma once
// Read before a section's header, says what its COURSE_EXERCISE means to a file that calls exercises in a page. There each
// exercise exists twice, ours and yours, and a demo calls neither: it imports "7.4 move_and_bounce" from the page, which
// passes the call on, once its numbers are within range. A friend can have the exercise's name without its parameters' names.
#include "judge/protocol/border.hpp"

#undef COURSE_EXERCISE // it meant nothing in the headers of earlier sections
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function##_in_page                                                                              \
        __attribute__((import_module("exercises"), import_name(number " " #function)));                                \
    template <class> struct function##_call;                                                                           \
    template <class Result, class... Arguments> struct function##_call<Result(Arguments...)> {                         \
        friend Result function(Arguments... values) {                                                                  \
            course::require_within(largest_number(number), values...);                                                 \
            return function##_in_page(values...);                                                                      \
        }                                                                                                              \
    };                                                                                                                 \
    template struct function##_call<decltype(function)>;                                                               \
    namespace subject {
