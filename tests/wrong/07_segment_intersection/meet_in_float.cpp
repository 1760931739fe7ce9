// 7.2: seven digits: a gap of a micrometre is gone
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static float side(const Segment &line, const Vec2 &point) {
    const Eigen::Vector2f a = (line.end - line.start).cast<float>(), p = (point - line.start).cast<float>();
    return a.x() * p.y() - a.y() * p.x();
}

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    for (const int axis : {0, 1}) {
        const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
        const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
        if (high_1 < low_2 || high_2 < low_1) return false;
    }
    return side(first, second.start) * side(first, second.end) <= 0
           && side(second, first.start) * side(second, first.end) <= 0;
}

} // namespace segment_intersection
