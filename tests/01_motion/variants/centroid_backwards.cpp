// 1.6: sums that run from the last corner to the first
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
    double area = 0;
    Vec2 weighted = {0, 0};
    for (std::size_t i = corners.size() - 1; i >= 2; --i) { // from behind
        const Vec2 p = corners[i] - corners[0], q = corners[i - 1] - corners[0];
        const double triangle = 0.5 * (p.y() * q.x() - p.x() * q.y());
        area -= triangle;
        weighted -= triangle / 3 * p;
        weighted -= triangle / 3 * q;
    }
    course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    return corners.front() + weighted / area;
}

} // namespace motion
