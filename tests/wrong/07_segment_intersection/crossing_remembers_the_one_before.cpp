// 7.1: the result is a static variable, so parallel lines get the answer of the call before
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    static std::optional<Crossing> result;
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) > parallel * a.norm() * b.norm()) {
        const double t = (gap.x() * b.y() - gap.y() * b.x()) / d;
        result = Crossing{t, (gap.x() * a.y() - gap.y() * a.x()) / d, motion.start + t * a};
    }
    return result;
}

} // namespace segment_intersection
