// A loop over an element of a list that is gone before the loop starts.
#include "rest.hpp"

namespace segment_intersection {

std::vector<std::vector<Segment>> pairs(const Segment &motion, const Segment &wall) { return {{motion, wall}}; }

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    for (const Segment &each : pairs(motion, wall)[0])
        if (each.start.x() > 1e9) return {};
    return right_answer(motion, wall);
}

} // namespace segment_intersection
