// 7.2: t is in 0..1, s is not asked: the second counts as an endless line
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double before = det(b, first.start - second.start), after = det(b, first.end - second.start);
    if (before == 0 && after == 0) {
        const double t_1 = (second.start - first.start).dot(a), t_2 = (second.end - first.start).dot(a);
        return std::max(t_1, t_2) >= 0 && std::min(t_1, t_2) <= a.squaredNorm();
    }
    return std::min(before, after) <= 0 && std::max(before, after) >= 0;
}

} // namespace segment_intersection
