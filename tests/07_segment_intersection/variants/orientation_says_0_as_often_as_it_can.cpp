// 7.6: as much doubt as the header allows, less what the doubt itself is off by
#include "segment_intersection.hpp"

namespace segment_intersection {

int orientation(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    if (std::abs(left - right) <= 5.5e-16 * (std::abs(left) + std::abs(right)) + 1e-300) return 0;
    return left > right ? 1 : -1;
}

} // namespace segment_intersection
