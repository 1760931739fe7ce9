// 7.1: by how far the motion's ends are from the wall's line, and the other way round
#include "segment_intersection.hpp"

namespace segment_intersection {

static double height(const Segment &line, const Vec2 &point) {
    const Vec2 along = line.end - line.start;
    return Vec2{-along.y(), along.x()}.dot(point - line.start);
}

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const double fall = -Vec2{-b.y(), b.x()}.dot(a); // from the motion's start to its end, times the wall's length
    const double sine = std::abs(fall) / (a.norm() * b.norm());
    if (!(sine > parallel_tolerance)) return {}; // 0/0 too

    const double t = height(wall, motion.start) / fall;
    const double s = height(motion, wall.start) / -fall;
    return LineIntersection{t, s, (1 - t) * motion.start + t * motion.end};
}

} // namespace segment_intersection
