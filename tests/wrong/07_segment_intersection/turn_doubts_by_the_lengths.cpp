// 7.6: 5e-16 |a| |b| is the doubt; along an axis both products are far smaller than that
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double d = a.x() * b.y() - a.y() * b.x();
    const double doubt = 5e-16 * a.norm() * b.norm() + 1e-301;
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
}

} // namespace segment_intersection
