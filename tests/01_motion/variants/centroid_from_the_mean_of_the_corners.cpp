// 1.6: triangles around the mean of the corners
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
    Vec2 origin = {0, 0};
    for (const Vec2 &corner : corners) origin += corner / double(corners.size());
    double area = 0;
    Vec2 weighted = {0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 p = corners[i] - origin, q = corners[(i + 1) % corners.size()] - origin;
        const double triangle = p.x() * q.y() - q.x() * p.y();
        area += triangle / 2;
        weighted += triangle / 6 * (p + q);
    }
    course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    return origin + weighted / area;
}

} // namespace motion
