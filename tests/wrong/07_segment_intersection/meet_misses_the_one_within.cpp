// 7.2: on one line it asks for the second's ends on the first, and misses the first within the second
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }
static bool on(const Segment &s, const Vec2 &p) {
    return det(s.end - s.start, p - s.start) == 0 && (s.start - p).dot(s.end - p) <= 0;
}

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double d = det(a, b);
    if (d == 0) return on(first, second.start) || on(first, second.end);
    const double t = det(gap, b) / d, s = det(gap, a) / d;
    return 0 <= t && t <= 1 && 0 <= s && s <= 1;
}

} // namespace segment_intersection
