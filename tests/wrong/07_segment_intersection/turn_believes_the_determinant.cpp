// 7.6: the sign of the computed determinant, whatever its roundings have made of it
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double d = a.x() * b.y() - a.y() * b.x();
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

} // namespace segment_intersection
