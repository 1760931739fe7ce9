// A path without return.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    if (motion.start.x() > 0) return right_answer(motion, wall);
}

} // namespace segment_intersection
