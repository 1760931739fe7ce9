// 7.6: seven digits
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const float left = float(a.x()) * float(b.y()), right = float(a.y()) * float(b.x());
    const float doubt = 1e-7f * (std::abs(left) + std::abs(right));
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
