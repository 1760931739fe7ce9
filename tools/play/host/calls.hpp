#pragma once
// Read before a section's header, says what its COURSE_EXERCISE means to a file that calls exercises in a page. There each
// exercise may be the reader's, which is a module of its own, and answers by frames, or else ours or a wrong one of ours, which
// are linked with the demo: the page knows which. A friend can have the exercise's name without its parameters' names.
// COURSE_OURS_APART: ours are modules of their own, too. COURSE_OURS_BESIDE: see asks.cpp. COURSE_EMITTED: for other files, which
// only declare these functions.
#include "judge/protocol/border.hpp"

#include <cstdlib>

extern "C" void play_take(void *to)
    __attribute__((import_module("play"), import_name("take"))); ///< what the reader's function has answered

namespace host {

inline bool asks_reader = false; ///< whether the page has functions of the reader's at all

/// What `yours` answers, through the page: arguments go there as bytes, and the size of the result comes back.
/// @return nothing if ours stands in for it
template <class Result, class... Arguments>
std::optional<Result> of_reader(int yours(const char *, std::size_t), const Arguments &...arguments) {
    if (!asks_reader) return {};
    course::wire::Writer out;
    (out.put(arguments), ...);
    const int size = yours(out.bytes.data(), out.bytes.size());
    if (size < 0) return {};
    std::string result(static_cast<std::size_t>(size), '\0');
    play_take(result.data());
    course::wire::Reader in{result};
    return in.take<Result>();
}

} // namespace host

#ifdef COURSE_OURS_APART
#define COURSE_OURS(function) std::abort() // the page has had them answer
#else
#define COURSE_OURS(function) return function##_ours(values...)
#endif
#ifdef COURSE_OURS_BESIDE
#define COURSE_OURS_FROM(name) __asm__("ours " name)
#define COURSE_UNASKED(function)                                                                                       \
    if (!host::asks_reader) COURSE_OURS(function) // as where a test calls it
#else
#define COURSE_OURS_FROM(name) __attribute__((import_module("exercises"), import_name(name)))
#define COURSE_UNASKED(function)
#endif
#ifdef COURSE_EMITTED
#define COURSE_EMIT(function)                                                                                          \
    decltype(&function) function##_emitted() { return &function; }
#else
#define COURSE_EMIT(function)
#endif

#undef COURSE_EXERCISE // it meant nothing in the headers of earlier sections
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function##_ours COURSE_OURS_FROM(number " " #function);                                         \
    int function##_of_reader(const char *, std::size_t)                                                                \
        __attribute__((import_module("yours"), import_name(number " " #function)));                                    \
    template <class> struct function##_call;                                                                           \
    template <class Result, class... Arguments> struct function##_call<Result(Arguments...)> {                         \
        friend Result function(Arguments... values) {                                                                  \
            COURSE_UNASKED(function);                                                                                  \
            course::require_within(largest_number(number), values...);                                                 \
            if (auto theirs = host::of_reader<Result>(function##_of_reader, values...)) return *std::move(theirs);     \
            COURSE_OURS(function);                                                                                     \
        }                                                                                                              \
    };                                                                                                                 \
    template struct function##_call<decltype(function)>;                                                               \
    COURSE_EMIT(function)                                                                                              \
    namespace subject {
