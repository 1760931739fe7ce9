// 7.6: 1e-15 is the bound for the true D; what was computed is off by as much as 4.5e-16 more
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double doubt = 1e-15 * (std::abs(left) + std::abs(right)) + 1e-300;
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
