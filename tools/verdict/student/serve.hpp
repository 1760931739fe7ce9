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
template <class Result, class... Arguments> struct Server {
    template <Result (*F)(Arguments...)> static void serve(Reader &in, Writer &out) {
        std::tuple<std::decay_t<Arguments>...> arguments{
            in.take<std::decay_t<Arguments>>()...}; // braces: left to right
        out.put(std::apply(F, arguments));
    }
};
template <class Result, class... Arguments, Result (*F)(Arguments...)>
constexpr Serve serve_function(std::integral_constant<Result (*)(Arguments...), F>) {
    return &Server<Result, Arguments...>::template serve<F>;
}

struct Served {
    explicit Served(Serve serve) { served[exercises++] = serve; }
};

} // namespace

#undef COURSE_EXERCISE // it meant nothing in the headers of earlier sections
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    static const ::Served function##_served{                                                                           \
        ::serve_function(std::integral_constant<decltype(&section::function), &section::function>{})};
#include COURSE_SECTION
