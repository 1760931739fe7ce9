// 7.6: each number with a lower and an upper bound
#include "segment_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace segment_intersection {

struct Range {
    double low, high;
};
static Range wide(double x) { return {x - std::abs(x) * 1.12e-16 - 1e-310, x + std::abs(x) * 1.12e-16 + 1e-310}; }
static Range times(const Range &p, const Range &q) {
    const auto [low, high] = std::minmax({p.low * q.low, p.low * q.high, p.high * q.low, p.high * q.high});
    return {low - std::abs(low) * 1.12e-16 - 1e-310, high + std::abs(high) * 1.12e-16 + 1e-310};
}
int orientation(const Segment &first, const Segment &second) {

    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const Range left = times(wide(a.x()), wide(b.y())), right = times(wide(a.y()), wide(b.x()));
    if (left.low > right.high) return 1;
    if (left.high < right.low) return -1;
    return 0;
}

} // namespace segment_intersection
