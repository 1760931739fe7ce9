// 7.5: the side by its unit normal, the ends by the quadratic formula
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
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    const Vec2 way = motion.end - motion.start, away = motion.start - nearest(wall, motion.start);
    if (way.dot(away) >= 0) return {};

    double t = away.norm() <= radius ? 0 : 2;
    if (t > 0) {
        const Vec2 along = (wall.end - wall.start).stableNormalized();
        Vec2 normal{-along.y(), along.x()};
        if (normal.dot(motion.start - wall.start) < 0) normal = -normal;
        const double height = normal.dot(motion.start - wall.start) - radius, closing = -normal.dot(way);
        if (closing > 0 && height >= 0) {
            const double s = along.dot(motion.start + height / closing * way - wall.start);
            if (s >= 0 && s <= (wall.end - wall.start).norm()) t = height / closing;
        }
        for (const Vec2 &end : {wall.start, wall.end}) {
            const Vec2 from = motion.start - end;
            const double a = way.squaredNorm(), b = way.dot(from), c = from.squaredNorm() - radius * radius;
            if (b < 0 && b * b >= a * c) t = std::min(t, (-b - std::sqrt(b * b - a * c)) / a);
        }
    }
    if (t > 1) return {};
    const Vec2 centre = motion.start + t * way;
    return Impact{t, centre, nearest(wall, centre)};
}

} // namespace segment_intersection
