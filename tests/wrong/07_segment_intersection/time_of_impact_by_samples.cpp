// 7.5: a thousand discs along the motion, and the first that overlaps: too late, and a fast one jumps over the wall
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static Vec2 nearest(const Segment &wall, const Vec2 &point) {
    const Vec2 along = wall.end - wall.start;
    const double square = along.squaredNorm();
    if (square == 0) return wall.start;
    return wall.start + std::clamp((point - wall.start).dot(along) / square, 0.0, 1.0) * along;
}

std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end, radius);
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    const Vec2 way = motion.end - motion.start;
    if (way.dot(motion.start - nearest(wall, motion.start)) >= 0) return {};
    for (int i = 0; i <= 1000; ++i) {
        const Vec2 centre = motion.start + i / 1000.0 * way;
        if ((centre - nearest(wall, centre)).norm() <= radius) return Impact{i / 1000.0, centre, nearest(wall, centre)};
    }
    return {};
}

} // namespace segment_intersection
