// 7.6: more digits, and no doubt: wrong more rarely, but wrong
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const long double d = (long double)a.x() * b.y() - (long double)a.y() * b.x();
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

} // namespace segment_intersection
