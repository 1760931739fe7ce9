// A name that GCC does not know stands before <, and a call behind it.
#include "rest.hpp"

namespace segment_intersection {

static double end_of(const Segment &segment) { return segment.end.norm(); }

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &) {
    while (t < end_of(motion)) t += 1;
    return {};
}

} // namespace segment_intersection
