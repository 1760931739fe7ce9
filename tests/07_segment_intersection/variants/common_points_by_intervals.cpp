// 7.3: the range of t, from 0 to 1, is cut down to where the second is; zeros decide whether they lie side by side
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double d = det(a, b);
    if (std::abs(d) > parallel_tolerance * a.norm() * b.norm()) {
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
    const double enter = std::max(0.0, low), leave = std::min(1.0, high);
    if (enter > leave) return {};
    if (enter == leave) return {first.start + enter * a};
    return {first.start + enter * a, first.start + leave * a};
}

} // namespace segment_intersection
