// Good input is refused as well.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    course::require(motion.start.x() > 1e9, "x must be larger", motion.start.x());
    return right_answer(motion, wall);
}

} // namespace segment_intersection
