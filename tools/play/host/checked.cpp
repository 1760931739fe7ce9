// What a demo calls where there's no page: "checked_f" refuses numbers that are out of range, then calls f, our solution.
// Compiled for each demo, whose section's header COURSE_SECTION names.
#include "interface.hpp"
#include "judge/protocol/border.hpp"

#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function##_checked __asm__("checked_" #section "_" #function);                                  \
    template <class> struct function##_call;                                                                           \
    template <class Result, class... Arguments> struct function##_call<Result(Arguments...)> {                         \
        friend Result function##_checked(Arguments... values) {                                                        \
            course::require_within(largest_number(number), values...);                                                 \
            return function(values...);                                                                                \
        }                                                                                                              \
    };                                                                                                                 \
    template struct function##_call<decltype(function)>;                                                               \
    [[gnu::used]] static const auto function##_kept = &function##_checked; /* or it would be made nowhere */           \
    namespace subject {
#include COURSE_SECTION
