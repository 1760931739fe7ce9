// 7.1: the law of sines
#include "segment_intersection.hpp"

#include <cmath>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {

    const Vec2 a = motion.end - motion.start, b = wall.end - wall.start, g = wall.start - motion.start;
    if (a.norm() == 0 || b.norm() == 0) return {};
    const double alpha = std::atan2(a.y(), a.x()), beta = std::atan2(b.y(), b.x());
    const double sine = std::sin(beta - alpha);
    if (std::abs(sine) <= parallel_tolerance) return {};
    const double gamma = std::atan2(g.y(), g.x());
    const double t = g.norm() * std::sin(beta - gamma) / sine / a.norm();
    const double s = g.norm() * std::sin(alpha - gamma) / sine / b.norm();
    return LineIntersection{t, s, motion.start + t * a};
}

} // namespace segment_intersection
