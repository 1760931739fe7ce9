// 7.5: step by step to where the distance would be one radius if it kept falling at its present rate
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static Vec2 nearest(const Segment &wall, const Vec2 &point) {
    const Vec2 along = wall.end - wall.start;
    if (along.isZero(0)) return wall.start;
    return wall.start + std::clamp((point - wall.start).dot(along) / along.dot(along), 0.0, 1.0) * along;
}

std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall) {
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    const Vec2 way = motion.end - motion.start;
    double t = 0;
    for (int i = 0; i < 200; ++i) { // the distance is convex, so no step is too long
        const Vec2 centre = motion.start + t * way, point = nearest(wall, centre), away = centre - point;
        const double distance = away.norm(), speed = -way.dot(away) / (distance > 0 ? distance : 1);
        if (t > 1 || (speed <= 0 && distance > radius * (1 + 1e-15))) return {};
        if (i == 0 && speed <= 0) return {};
        const double step = (distance - radius) / speed;
        if (!(step > 1e-17 + 1e-16 * t)) return Impact{t, centre, point};
        t += step;
    }
    const Vec2 centre = motion.start + t * way;
    return Impact{t, centre, nearest(wall, centre)};
}

} // namespace segment_intersection
