// 7.6: the ends stand where the vectors must: right for segments that start at (0, 0)
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const double left = first.end.x() * second.end.y(), right = first.end.y() * second.end.x();
    const double doubt = 5e-16 * (std::abs(left) + std::abs(right)) + 1e-301;
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
