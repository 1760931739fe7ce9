// 7.3: 0 and 1 are on the wrong sides of min and max: the union in place of what they share
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

std::vector<Vec2> shared(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double d = det(a, b);
    if (std::abs(d) > parallel * a.norm() * b.norm()) {
        const double t = det(gap, b) / d, s = det(gap, a) / d;
        if (t < 0 || t > 1 || s < 0 || s > 1) return {};
        return {first.start + t * a};
    }
    if (det(gap, a) != 0 || det(gap, b) != 0) return {}; // side by side
    if (a.isZero(0))
        return (second.start - first.start).dot(second.end - first.start) <= 0 ? std::vector{first.start}
                                                                               : std::vector<Vec2>{};
    const double square = a.squaredNorm();
    const auto [low, high] = std::minmax({gap.dot(a) / square, (second.end - first.start).dot(a) / square});
    const double enter = std::min(0.0, low), leave = std::max(1.0, high);
    if (low > 1 || high < 0) return {};
    if (enter == leave) return {first.start + enter * a};
    return {first.start + enter * a, first.start + leave * a};
}

} // namespace segment_intersection
