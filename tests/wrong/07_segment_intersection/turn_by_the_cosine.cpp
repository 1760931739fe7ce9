// 7.6: the dot product: ahead and behind in place of left and right
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double doubt = 1e-15 * (std::abs(a.x() * b.x()) + std::abs(a.y() * b.y()));
    return a.dot(b) > doubt ? 1 : a.dot(b) < -doubt ? -1 : 0;
}

} // namespace segment_intersection
