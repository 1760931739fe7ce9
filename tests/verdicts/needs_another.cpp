// An exercise that calls another one, which nobody has touched.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    if (!segments_intersect(motion, wall)) return {};
    return right_answer(motion, wall);
}

} // namespace segment_intersection
