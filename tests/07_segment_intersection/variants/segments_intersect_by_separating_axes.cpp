// 7.2: separating axes: along both segments, and across them
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static bool gap_along(const Vec2 &axis, const Segment &first, const Segment &second) {
    const auto [low_1, high_1] = std::minmax({0.0, axis.dot(first.end - first.start)});
    const auto [low_2, high_2] =
        std::minmax({axis.dot(second.start - first.start), axis.dot(second.end - first.start)});
    return high_1 < low_2 || high_2 < low_1;
}

bool segments_intersect(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const std::vector<Vec2> axes{Vec2::UnitX(),      Vec2::UnitY(), a, b, a.unitOrthogonal() * a.norm(),
                                 Vec2{b.y(), -b.x()}};
    for (const Vec2 &axis : axes)
        if (gap_along(axis, first, second)) return false;
    return true;
}

} // namespace segment_intersection
