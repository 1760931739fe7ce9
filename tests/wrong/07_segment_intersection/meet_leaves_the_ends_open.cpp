// 7.2: 0 < t < 1, the "(0..1)" of the source: a touch is no meeting
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    if (const double d = det(a, b); d != 0) {
        const double t = det(gap, b) / d, s = det(gap, a) / d;
        return 0 < t && t < 1 && 0 < s && s < 1;
    }
    if (det(gap, a) != 0 || det(gap, b) != 0) return false;
    for (const int axis : {0, 1}) {
        const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
        const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
        if (high_1 < low_2 || high_2 < low_1) return false;
    }
    return true;
}

} // namespace segment_intersection
