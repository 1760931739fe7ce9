// 7.2: "not outside of 0..1" is true of NaN, so all parallel segments meet
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double t = det(gap, b) / det(a, b), s = det(gap, a) / det(a, b); // 0/0
    return !(t < 0 || t > 1 || s < 0 || s > 1);
}

} // namespace segment_intersection
