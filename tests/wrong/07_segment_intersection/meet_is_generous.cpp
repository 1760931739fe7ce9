// 7.2: what is no more than a nanometre away counts as met, for fear of roundings
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static bool apart(const Segment &line, const Segment &other) {
    const Vec2 along = line.end - line.start;
    const Vec2 normal = Vec2{-along.y(), along.x()}.stableNormalized();
    const double from = normal.dot(other.start - line.start), to = normal.dot(other.end - line.start);
    return std::min(from, to) > 1e-9 || std::max(from, to) < -1e-9;
}

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    for (const int axis : {0, 1}) {
        const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
        const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
        if (high_1 < low_2 || high_2 < low_1) return false;
    }
    return !apart(first, second) && !apart(second, first);
}

} // namespace segment_intersection
