#pragma once
// How a section names, once, what crosses to another process: the fields of its structs, and its exercises.

#include <string_view>

/// Inside a struct, in the order of declaration: the units of its fields, then the fields, for the wire and for messages.
/// `COURSE_FIELDS("m, m/s, 1", position, velocity, restitution)`; 1 is "no unit". The struct stays an aggregate.
/// Templates, so that they cost a student's file nothing: they are made only where somebody looks at the fields.
#define COURSE_FIELDS(units, ...)                                                                                      \
    static constexpr std::string_view field_units = units;                                                             \
    static constexpr std::string_view field_names = #__VA_ARGS__;                                                      \
    auto fields(const auto &look) { return look(__VA_ARGS__); }                                                        \
    auto fields(const auto &look) const { return look(__VA_ARGS__); }

/// One line for each exercise, in namespace `subject` at the end of a section's header: its number, its tier, its
/// function, the names and units of what goes in, the unit of what comes out.
/// `COURSE_EXERCISE("6.2", core, reflection, reflect, "incoming [m/s], normal [1]", "m/s")`
/// The tests and the server give this line its meaning before they include a section's header; to a program, and to
/// what a student compiles, it means nothing.
#ifndef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)
#endif
