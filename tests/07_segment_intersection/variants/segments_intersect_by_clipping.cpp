// 7.2: the range of t on the first is cut down by the second's box and line
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

namespace {
struct Interval {
    double low = 0, high = 1;
    void cut(double from, double to, double bottom, double top) { // where from + t (to - from) is in [bottom, top]
        if (from == to) {
            if (from < bottom || from > top) high = -1;
            return;
        }
        const auto [enter, leave] = std::minmax({(bottom - from) / (to - from), (top - from) / (to - from)});
        low = std::max(low, enter);
        high = std::min(high, leave);
    }
};
} // namespace

bool segments_intersect(const Segment &first, const Segment &second) {
    const Vec2 b = second.end - second.start;
    // in the second's own frame: how far along, and how far across, both times its length
    const auto along = [&](const Vec2 &p) { return b.dot(p - second.start); };
    const auto across = [&](const Vec2 &p) {
        return b.x() * (p.y() - second.start.y()) - b.y() * (p.x() - second.start.x());
    };

    if (b.isZero(0)) { // a point: both coordinates must equal its own
        const Vec2 a = first.end - first.start, gap = second.start - first.start;
        return a.x() * gap.y() == a.y() * gap.x()
               && (a.isZero(0) ? gap.isZero(0) : a.dot(gap) >= 0 && a.dot(gap) <= a.dot(a));
    }
    const double from = across(first.start), to = across(first.end);
    if (from * to > 0) return false;
    Interval t;
    if (from == 0 && to == 0) { // on one line
        t.cut(along(first.start), along(first.end), 0, b.dot(b));
        return t.low <= t.high;
    }
    // where it crosses the second's line, weighted by the heights of both ends, without dividing
    const double there = (along(first.start) * to - along(first.end) * from) * (to > from ? 1 : -1);
    return there >= 0 && there <= b.dot(b) * std::abs(to - from);
}

} // namespace segment_intersection
