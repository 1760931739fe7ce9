#pragma once
// Gives COURSE_EXERCISE its meaning for the side that answers: read the arguments, call the student's function, write the result.
// Includes the header of the section, which COURSE_SECTION names. Only for server.cpp and direct.cpp: all of it is local.

#include "judge/protocol/border.hpp"

namespace {

using course::wire::Reader, course::wire::Writer;
using Serve = void (*)(double limit, Reader &, Writer &);
struct Exercise {
    Serve serve;
    double limit; ///< of the numbers that it takes

    void operator()(Reader &in, Writer &out) const { serve(limit, in, out); }
};
Exercise served[64];
std::uint32_t exercises = 0;

/// Reads the arguments, refuses numbers beyond the limit, calls the student's function, writes the result.
template <class Result, class... Arguments>
void serve(Result (*function)(Arguments...), double limit, Reader &in, Writer &out) {
    const std::tuple<std::decay_t<Arguments>...> arguments{in.take<std::decay_t<Arguments>>()...}; // left to right
    std::apply([limit](const auto &...each) { course::require_within(limit, each...); }, arguments);
    out.put(std::apply(function, arguments));
}
template <auto F> void serve_function(double limit, Reader &in, Writer &out) { serve(F, limit, in, out); }

/// Whether a section is the one whose header is COURSE_SECTION: that includes those of earlier sections, whose functions are ours.
constexpr bool is_served(std::string_view section) {
    return std::string_view{COURSE_SECTION}.substr(0, sizeof COURSE_SECTION - sizeof ".hpp") == section;
}
template <bool Own, auto F> struct Served {
    explicit Served(double limit) {
        if constexpr (Own) served[exercises++] = {&serve_function<F>, limit};
    }
};

} // namespace

#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    static const ::Served<::is_served(#section), &section::function> function##_served{largest_number(number)};
#include COURSE_SECTION
