// 7.2: the textbook's four orientations and four special cases; one that may be due to rounding counts as 0
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static int orientation(const Vec2 &a, const Vec2 &b, const Vec2 &c) {
    const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
    if (std::abs(left - right) <= 1e-14 * (std::abs(left) + std::abs(right))) return 0;
    return left > right ? 1 : -1;
}
static bool in_box(const Vec2 &a, const Vec2 &b, const Vec2 &c) {
    return std::min(a.x(), b.x()) <= c.x() && c.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= c.y()
           && c.y() <= std::max(a.y(), b.y());
}

bool segments_intersect(const Segment &first, const Segment &second) {
    const auto &[a, b] = first;
    const auto &[c, d] = second;
    const int abc = orientation(a, b, c), abd = orientation(a, b, d), cda = orientation(c, d, a),
              cdb = orientation(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) || (cda == 0 && in_box(c, d, a))
           || (cdb == 0 && in_box(c, d, b));
}

} // namespace segment_intersection
