#pragma once
// What a student has not touched: every exercise of section 7 but the first. Each file here is a student's, and has one
// thing the matter with it; the .txt beside it is what `./course check 7 --file` says. See tests/tools/golden.cpp for how
// the two are put together.
#include "segment_intersection.hpp"

namespace segment_intersection {

bool segments_intersect(const Segment &, const Segment &) { throw course::NotYet{"untouched"}; }
std::vector<Vec2> common_points(const Segment &, const Segment &) { throw course::NotYet{"untouched"}; }
Ball move_and_bounce(const Ball &, const std::vector<Vec2> &, double) { throw course::NotYet{"untouched"}; }
std::optional<Impact> time_of_impact(const Segment &, double, const Segment &) { throw course::NotYet{"untouched"}; }
int orientation(const Segment &, const Segment &) { throw course::NotYet{"untouched"}; }

/// What the first exercise asks for.
std::optional<LineIntersection> right_answer(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start, b = wall.end - wall.start, gap = wall.start - motion.start;
    const double d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) <= parallel_tolerance * a.norm() * b.norm()) return {};
    const double t = (gap.x() * b.y() - gap.y() * b.x()) / d;
    const double s = (gap.x() * a.y() - gap.y() * a.x()) / d;
    return LineIntersection{t, s, motion.start + t * a};
}

} // namespace segment_intersection
