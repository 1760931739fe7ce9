// 7.5: the distance falls, then grows: bisection finds where it is least, and then where it is one radius
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
    const auto away = [&](double t) -> Vec2 { return motion.start + t * way - nearest(wall, motion.start + t * way); };
    if (way.dot(away(0)) >= 0) return {};

    double from = 0, least = 1;
    for (int i = 0; i < 1100 && from < least; ++i) {
        const double middle = (from + least) / 2;
        if (way.dot(away(least)) <= 0) break; // still getting closer at the end of the motion
        (way.dot(away(middle)) < 0 ? from : least) = middle;
        if (middle == (from + least) / 2) break; // no number between them
    }
    if (away(least).norm() > radius && away(from).norm() > radius) return {};
    double clear = -1, touched = away(from).norm() <= radius ? from : least;
    if (away(0).norm() <= radius) touched = 0;
    else
        for (clear = 0; clear < (clear + touched) / 2 && (clear + touched) / 2 < touched;)
            (away((clear + touched) / 2).norm() > radius ? clear : touched) = (clear + touched) / 2;
    const Vec2 centre = motion.start + touched * way;
    return Impact{touched, centre, nearest(wall, centre)};
}

} // namespace segment_intersection
