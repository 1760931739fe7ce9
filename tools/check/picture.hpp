#pragma once
// A red verdict that one can see: the call's arguments, the answer in orange, and what was expected, dashed.

#include "judge/protocol/verdict.hpp"

#include <optional>
#include <string>

namespace course {

/// Points, arrows, balls, segments, boxes, arms and lists of points lie in the plane, x to the right and y up; an angle is
/// a direction. An answer of numbers alone is bars, beside the arguments that have its unit.
/// @return an SVG of 480 px; nothing where a picture would say nothing
std::optional<std::string> picture_of(const Verdict &verdict);

/// What the classes of these pictures mean, for the page that they're in.
std::string style_of_pictures();

} // namespace course
