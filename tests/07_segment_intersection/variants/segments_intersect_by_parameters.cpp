// 7.2: t and s between 0 and 1, ends included; parallel ones by the line's distance, and the places along it
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

bool segments_intersect(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    if (const double d = det(a, b); std::abs(d) > parallel_tolerance * a.norm() * b.norm()) {
        const double t = det(gap, b) / d, s = det(gap, a) / d;
        return 0 <= t && t <= 1 && 0 <= s && s <= 1;
    }
    const Vec2 along = a.squaredNorm() > b.squaredNorm() ? a : b;
    if (along.isZero(0)) return gap.isZero(0); // two points
    if (std::abs(det(gap, along)) > 1e-14 * gap.norm() * along.norm()) return false;
    const auto [low, high] = std::minmax({along.dot(gap), along.dot(second.end - first.start)});
    return high >= std::min(0.0, along.dot(a)) && low <= std::max(0.0, along.dot(a));
}

} // namespace segment_intersection
