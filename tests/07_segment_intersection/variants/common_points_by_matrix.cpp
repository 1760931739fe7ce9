// 7.3: the crossing by an inverse matrix; on one line, the middle two of the four ends
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    Eigen::Matrix2d m;
    m << first.end - first.start, second.start - second.end;
    const Vec2 gap = second.start - first.start;
    if (std::abs(m.determinant()) > parallel_tolerance * m.col(0).norm() * m.col(1).norm()) {
        const Vec2 ts = m.inverse() * gap;
        const double hair = 1e-12; // an end a rounding away counts as the end itself
        if (ts.minCoeff() < -hair || ts.maxCoeff() > 1 + hair) return {};
        return {first.start + std::clamp(ts.x(), 0.0, 1.0) * m.col(0)};
    }
    const Vec2 along = m.col(0).isZero(0) ? m.col(1) : m.col(0), across{-along.y(), along.x()};
    if (along.isZero(0)) return gap.isZero(0) ? std::vector{first.start} : std::vector<Vec2>{};
    if (across.dot(gap) != 0) return {};

    const auto before = [&](const Vec2 &p, const Vec2 &q) { return along.dot(p) < along.dot(q); };
    const auto [low_1, high_1] = std::minmax({first.start, first.end}, before);
    const auto [low_2, high_2] = std::minmax({second.start, second.end}, before);
    const Vec2 low = before(low_1, low_2) ? low_2 : low_1, high = before(high_1, high_2) ? high_1 : high_2;
    if (before(high, low)) return {};
    if (low == high) return {low};
    return {low, high}; // `along` is the first's direction, unless it is a point
}

} // namespace segment_intersection
