// 7.1: the source's two fractions as they stand, and the point by coordinates alone
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const Vec2 &p0 = motion.start, &p1 = motion.end, &p2 = wall.start, &p3 = wall.end;
    const Vec2 s1 = p1 - p0, s2 = p3 - p2;
    const double d = -s2.x() * s1.y() + s1.x() * s2.y();
    if (std::abs(d) <= parallel_tolerance * std::sqrt(s1.squaredNorm() * s2.squaredNorm())) return {};

    const double s = (-s1.y() * (p0.x() - p2.x()) + s1.x() * (p0.y() - p2.y())) / d;
    const double t = (s2.x() * (p0.y() - p2.y()) - s2.y() * (p0.x() - p2.x())) / d;
    const double area_1 = p0.x() * p1.y() - p0.y() * p1.x(), area_2 = p2.x() * p3.y() - p2.y() * p3.x();
    return LineIntersection{t, s, (area_2 * s1 - area_1 * s2) / d};
}

} // namespace segment_intersection
