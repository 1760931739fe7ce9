// 7.6: is one product larger than the other by more than a few roundings? Nothing is subtracted after the start
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

int orientation(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double more = 1 + 1e-15, large = std::max(std::abs(left), std::abs(right)),
                 small = std::min(std::abs(left), std::abs(right));
    if (large <= 1e-301 || ((left > 0) == (right > 0) && large <= small * more)) return 0;
    return left > right ? 1 : -1;
}

} // namespace segment_intersection
