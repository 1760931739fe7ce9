// 7.6: the difference of two atan2, which jumps by a full turn on the left, and is rounded like all
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double angle = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
    return angle > 1e-15 ? 1 : angle < -1e-15 ? -1 : 0;
}

} // namespace segment_intersection
