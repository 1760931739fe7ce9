// 7.1: a x + b y = c for each line
#include "segment_intersection.hpp"

#include <cmath>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {

    const double a1 = motion.end.y() - motion.start.y(), b1 = motion.start.x() - motion.end.x();
    const double c1 = a1 * motion.start.x() + b1 * motion.start.y();
    const double a2 = wall.end.y() - wall.start.y(), b2 = wall.start.x() - wall.end.x();
    const double c2 = a2 * wall.start.x() + b2 * wall.start.y();
    const double d = a1 * b2 - a2 * b1;
    if (std::abs(d) <= parallel_tolerance * std::hypot(a1, b1) * std::hypot(a2, b2)) return {};
    const Vec2 point{(b2 * c1 - b1 * c2) / d, (a1 * c2 - a2 * c1) / d};
    const Vec2 a{-b1, a1}, b{-b2, a2};
    return LineIntersection{(point - motion.start).dot(a) / a.dot(a), (point - wall.start).dot(b) / b.dot(b), point};
}

} // namespace segment_intersection
