// 1.6: trapezoids below each side, down to the level of the first corner
#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace motion {

Vec2 centroid(const std::vector<Vec2> &corners) {
    course::require(corners.size() >= 3, "the number of corners must be three or more", double(corners.size()));
    double size = 0;
    for (const Vec2 &p : corners) {
        for (const Vec2 &q : corners) size = std::max(size, (p - q).squaredNorm());
    }
    const Vec2 origin = corners[0];
    double area = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 p = corners[i] - origin, q = corners[(i + 1) % corners.size()] - origin;
        const double width = p.x() - q.x();
        area += width * (p.y() + q.y()) / 2;
        x += width * (p.x() * (2 * p.y() + q.y()) + q.x() * (p.y() + 2 * q.y())) / 6;
        y += width * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 6;
    }
    course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    return origin + Vec2{x, y} / area;
}

} // namespace motion
