// 7.1: |D| < 1e-9 m² counts as parallel, however short the segments: a micrometre crosses nothing
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) < 1e-9) return {};
    const double t = (gap.x() * b.y() - gap.y() * b.x()) / d;
    const double s = (gap.x() * a.y() - gap.y() * a.x()) / d;
    return Crossing{t, s, motion.start + t * a};
}

} // namespace segment_intersection
