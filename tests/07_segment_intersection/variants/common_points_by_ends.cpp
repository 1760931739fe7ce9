// 7.3: every end that lies on the other segment, in order and once; if there is none, the crossing
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }
static bool on(const Segment &s, const Vec2 &p) {
    return det(s.end - s.start, p - s.start) == 0 && (s.start - p).dot(s.end - p) <= 0;
}

std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    std::vector<Vec2> ends;
    for (const Vec2 &end : {first.start, first.end, second.start, second.end})
        if (on(first, end) && on(second, end)) ends.push_back(end);

    const Vec2 a = first.end - first.start, b = second.end - second.start, gap = second.start - first.start;
    if (ends.empty()) {
        const double d = det(a, b), t = det(gap, b) / d, s = det(gap, a) / d;
        if (std::abs(d) > parallel_tolerance * a.norm() * b.norm() && t > 0 && t < 1 && s > 0 && s < 1)
            ends.push_back(first.start + t * a);
        return ends;
    }
    std::sort(ends.begin(), ends.end(), [&](const Vec2 &p, const Vec2 &q) { return a.dot(p) < a.dot(q); });
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if (ends.size() > 2) ends.erase(ends.begin() + 1, ends.end() - 1);
    return ends;
}

} // namespace segment_intersection
