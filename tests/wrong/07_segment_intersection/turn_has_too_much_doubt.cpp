// 7.6: below 1e-9 of the products it says 0, to be on the safe side
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double doubt = 1e-9 * (std::abs(left) + std::abs(right));
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
