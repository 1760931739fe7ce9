// 7.1: lines that cross beyond the ends are said not to cross; that is exercise 7.2
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) <= parallel * a.norm() * b.norm()) return {};
    const double t = (gap.x() * b.y() - gap.y() * b.x()) / d;
    const double s = (gap.x() * a.y() - gap.y() * a.x()) / d;
    if (t < 0 || t > 1 || s < 0 || s > 1) return {};
    return Crossing{t, s, motion.start + t * a};
}

} // namespace segment_intersection
