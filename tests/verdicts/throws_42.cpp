// An exception that is a number.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    throw 42;
}

} // namespace segment_intersection
