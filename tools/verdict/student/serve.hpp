#pragma once
// Gives COURSE_EXERCISE its meaning for the side that answers: read the arguments, call the student's function, write its result.
// Includes the header of the section, which COURSE_SECTION names. Only for server.cpp and direct.cpp: all of it is local.

#include "verdict/shared/wire.hpp"

namespace {

using course::wire::Reader, course::wire::Writer;
using Serve = void (*)(Reader &, Writer &);
Serve served[64];
std::uint32_t exercises = 0;

/// Reads the arguments, calls the student's function, writes its result.
template <class Result, class... Arguments> void serve(Result (*function)(Arguments...), Reader &in, Writer &out) {
    std::tuple<std::decay_t<Arguments>...> arguments{in.take<std::decay_t<Arguments>>()...}; // braces: left to right
    out.put(std::apply(function, arguments));
}
template <auto F> void serve_function(Reader &in, Writer &out) { serve(F, in, out); }

/// A line of the section's header, which includes those of earlier sections first: their functions are ours.
struct Served {
    Served(std::string_view section, Serve serve) {
        static std::string_view last;
        if (section != std::exchange(last, section)) exercises = 0;
        served[exercises++] = serve;
    }
};

} // namespace

#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    static const ::Served function##_served{#section, &::serve_function<&section::function>};
#include COURSE_SECTION
