// 7.6: fma gives what each product has lost; only the differences are left to doubt
#include "segment_intersection.hpp"

namespace segment_intersection {

int orientation(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    const double left = a.x() * b.y(), right = a.y() * b.x();
    const double lost = std::fma(a.x(), b.y(), -left) - std::fma(a.y(), b.x(), -right);
    const double d = (left - right) + lost;
    const double doubt = 2.5e-16 * (std::abs(left) + std::abs(right)) + 1e-301;
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
}

} // namespace segment_intersection
