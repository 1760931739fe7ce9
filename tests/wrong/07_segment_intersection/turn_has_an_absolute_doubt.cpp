// 7.6: |D| < 1e-12 m² is 0, however short the segments are, and enough for no long ones
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double d = a.x() * b.y() - a.y() * b.x();
    return d > 1e-12 ? 1 : d < -1e-12 ? -1 : 0;
}

} // namespace segment_intersection
