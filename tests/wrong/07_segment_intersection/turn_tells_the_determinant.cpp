// 7.6: D itself, cut to a whole number, in place of its sign
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    return int(std::clamp(a.x() * b.y() - a.y() * b.x(), -2e9, 2e9));
}

} // namespace segment_intersection
