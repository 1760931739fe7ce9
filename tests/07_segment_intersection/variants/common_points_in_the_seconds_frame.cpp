// 7.3: measured along the second, in its own frame, and turned round at the end
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    const bool upright = std::abs(second.end.y() - second.start.y()) > std::abs(second.end.x() - second.start.x());
    const Vec2 b = second.end - second.start, turned{-b.y(), b.x()};
    if (b.isZero(0))
        return first.start == first.end && first.start != second.start ? std::vector<Vec2>{}
               : first.start == second.start                           ? std::vector<Vec2>{second.start}
                                             : segment_intersection::common_points(second, first);

    const auto height = [&](const Vec2 &p) { // 0 if it may be due to rounding
        const Vec2 gap = p - second.start;
        return std::abs(turned.dot(gap)) <= 1e-14 * b.norm() * gap.norm() ? 0 : turned.dot(gap);
    };
    const double from = height(first.start), to = height(first.end);
    if (from * to > 0) return {};
    const auto place = [&](const Vec2 &p) { return (p - second.start)[upright] / b[upright]; };
    if (from == 0 && to == 0) { // on one line: the parts of the first beyond the second are cut off
        const auto pull = [&](const Vec2 &p) { return place(p) < 0 ? second.start : place(p) > 1 ? second.end : p; };
        const Vec2 low = pull(first.start), high = pull(first.end);
        if (std::max(place(first.start), place(first.end)) < 0 || std::min(place(first.start), place(first.end)) > 1)
            return {};
        return low == high ? std::vector{low} : std::vector{low, high};
    }
    const Vec2 point = first.start + from / (from - to) * (first.end - first.start);
    const Vec2 a = first.end - first.start;
    const auto side = [&](const Vec2 &p) {
        return a.x() * (p.y() - first.start.y()) - a.y() * (p.x() - first.start.x());
    };
    if (side(second.start) * side(second.end) > 0) return {};
    return {point};
}

} // namespace segment_intersection
