// 7.6: only the roundings of the products are counted, not those of the four differences
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double doubt = 1.2e-16 * (std::abs(left) + std::abs(right));
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
