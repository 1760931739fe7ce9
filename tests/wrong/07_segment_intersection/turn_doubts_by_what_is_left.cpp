// 7.6: the doubt is a share of D itself, of which all may be noise
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double d = a.x() * b.y() - a.y() * b.x();
    const double doubt = 1e-15 * std::abs(d);
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
}

} // namespace segment_intersection
