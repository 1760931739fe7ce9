// 7.2: D = 0 means "no", also for segments that overlap on one line, and for points
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double d = det(a, b);
    if (d == 0) return false;
    const double t = det(gap, b) / d, s = det(gap, a) / d;
    return 0 <= t && t <= 1 && 0 <= s && s <= 1;
}

} // namespace segment_intersection
