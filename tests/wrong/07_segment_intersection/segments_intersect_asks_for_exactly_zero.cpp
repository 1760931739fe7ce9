// 7.2: D == 0 is asked for; on one line, thirds give D = 1e-17, t and s are noise, and a wide gap is bridged
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }
static bool on(const Segment &s, const Vec2 &p) {
    return det(s.end - s.start, p - s.start) == 0 && (s.start - p).dot(s.end - p) <= 0;
}

bool segments_intersect(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    if (const double d = det(a, b); d != 0) {
        const double t = det(gap, b) / d, s = det(gap, a) / d;
        return 0 <= t && t <= 1 && 0 <= s && s <= 1;
    }
    return on(first, second.start) || on(first, second.end) || on(second, first.start) || on(second, first.end);
}

} // namespace segment_intersection
