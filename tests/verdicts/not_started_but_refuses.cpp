// A stub that refuses bad input by itself, and waits for the rest: no test that it passes makes it started.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    throw course::NotYet{"start from the two vectors along the segments, and from their determinant"};
}

} // namespace segment_intersection
