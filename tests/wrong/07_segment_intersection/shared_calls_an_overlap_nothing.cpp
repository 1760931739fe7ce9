// 7.3: parallel segments share nothing: D = 0, and that is that
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

std::vector<Vec2> shared(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    const double d = det(a, b);
    if (std::abs(d) > parallel * a.norm() * b.norm()) {
        const double t = det(gap, b) / d, s = det(gap, a) / d;
        if (t < 0 || t > 1 || s < 0 || s > 1) return {};
        return {first.start + t * a};
    }
    return {};
}

} // namespace segment_intersection
