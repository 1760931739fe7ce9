// 1.6: the middle of the box round it
#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace motion {

Vec2 centroid(const std::vector<Vec2> &corners) {
    course::require(corners.size() >= 3, "the number of corners must be three or more", double(corners.size()));
    double size = 0;
    for (const Vec2 &p : corners) {
        course::require_range(p);
        for (const Vec2 &q : corners) size = std::max(size, (p - q).squaredNorm());
    }
    const Vec2 origin = corners[0];
    double area = 0;
    Vec2 weighted = {0, 0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec2 p = corners[i] - origin, q = corners[i + 1] - origin;
        const double triangle = (p.x() * q.y() - p.y() * q.x()) / 2;
        area += triangle;
        weighted += triangle * (p + q) / 3;
    }
    course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    Vec2 low = origin, high = origin;
    for (const Vec2 &corner : corners) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    return (low + high) / 2;
}

} // namespace motion
