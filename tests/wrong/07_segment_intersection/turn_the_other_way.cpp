// 7.6: y down, as on a screen: left and right have changed places
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double doubt = 5e-16 * (std::abs(left) + std::abs(right)) + 1e-301;
    return left - right > doubt ? -1 : left - right < -doubt ? 1 : 0;
}

} // namespace segment_intersection
