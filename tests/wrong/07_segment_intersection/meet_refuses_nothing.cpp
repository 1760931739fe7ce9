// 7.2: what is not a number is compared, which is always false, and so gets an answer
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double side(const Segment &line, const Vec2 &point) {
    const Vec2 a = line.end - line.start, p = point - line.start;
    return a.x() * p.y() - a.y() * p.x();
}

bool meet(const Segment &first, const Segment &second) {
    for (const int axis : {0, 1}) {
        const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
        const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
        if (high_1 < low_2 || high_2 < low_1) return false;
    }
    const auto [low_1, high_1] = std::minmax({side(first, second.start), side(first, second.end)});
    const auto [low_2, high_2] = std::minmax({side(second, first.start), side(second, first.end)});
    return low_1 <= 0 && high_1 >= 0 && low_2 <= 0 && high_2 >= 0;
}

} // namespace segment_intersection
