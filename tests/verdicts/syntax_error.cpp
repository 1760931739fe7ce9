// A name that is not there, and a missing semicolon.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const double d = det(motion.end, wall.end)
    return right_answer(motion, wall);
}

} // namespace segment_intersection
