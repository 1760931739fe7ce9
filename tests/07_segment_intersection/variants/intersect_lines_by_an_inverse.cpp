// 7.1: two equations as a 2 x 2 matrix, solved by its inverse
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    Eigen::Matrix2d m;
    m << motion.end - motion.start, wall.start - wall.end;
    if (std::abs(m.determinant()) <= parallel_tolerance * m.col(0).norm() * m.col(1).norm()) return {};

    const Vec2 ts = m.inverse() * (wall.start - motion.start);
    return LineIntersection{ts.x(), ts.y(), wall.start - ts.y() * m.col(1)};
}

} // namespace segment_intersection
