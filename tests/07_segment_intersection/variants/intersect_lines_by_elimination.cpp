// 7.1: LU with full pivoting, and "parallel" asked of unit vectors
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const Vec2 a = motion.end - motion.start, b = wall.end - wall.start;
    if (a.isZero(0) || b.isZero(0)) return {};
    const Vec2 unit_a = a.normalized(), unit_b = b.normalized();
    if (std::abs(unit_a.x() * unit_b.y() - unit_a.y() * unit_b.x()) <= parallel_tolerance) return {};

    Eigen::Matrix2d m;
    m << unit_a, -unit_b;
    const Vec2 metres = Eigen::FullPivLU<Eigen::Matrix2d>{m}.solve(wall.start - motion.start);
    return LineIntersection{metres.x() / a.norm(), metres.y() / b.norm(), motion.start + metres.x() * unit_a};
}

} // namespace segment_intersection
