// 7.6: the steeper one is on the left; so it is, as long as both run to the right
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double slope_1 = a.y() / a.x(), slope_2 = b.y() / b.x();
    const double doubt = 1e-15 * (std::abs(slope_1) + std::abs(slope_2));
    return slope_2 - slope_1 > doubt ? 1 : slope_2 - slope_1 < -doubt ? -1 : 0;
}

} // namespace segment_intersection
