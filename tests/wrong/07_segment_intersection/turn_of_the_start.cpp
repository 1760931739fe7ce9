// 7.6: on which side of the first the second starts, which is exercise 7.2 and not where it points
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, gap = second.start - first.start;
    const double left = a.x() * gap.y(), right = a.y() * gap.x();
    const double doubt = 5e-16 * (std::abs(left) + std::abs(right)) + 1e-301;
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
