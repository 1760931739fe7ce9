// 7.1: the gap runs from the wall to the motion, and only one of the two numerators was turned with it
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = motion.start - wall.start;

    const double d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) <= parallel * a.norm() * b.norm()) return {};
    const double t = (b.x() * gap.y() - b.y() * gap.x()) / d;
    const double s = (a.y() * gap.x() - a.x() * gap.y()) / d;
    return Crossing{t, s, motion.start + t * a};
}

} // namespace segment_intersection
