// 7.1: slopes are compared, upright lines apart; but what is a rounding of a slope of 30000?
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = a.x() * b.y() - a.y() * b.x();
    if (a.norm() == 0 || b.norm() == 0 || (a.x() == 0 && b.x() == 0)) return {};
    if (std::abs(a.y() / a.x() - b.y() / b.x()) <= parallel) return {};
    const double t = (gap.x() * b.y() - gap.y() * b.x()) / d;
    const double s = (gap.x() * a.y() - gap.y() * a.x()) / d;
    return Crossing{t, s, motion.start + t * a};
}

} // namespace segment_intersection
