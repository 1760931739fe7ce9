// A division of whole numbers, by zero.
#include "rest.hpp"

namespace segment_intersection {

int parts = 0;

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    auto found = right_answer(motion, wall);
    if (found) found->t = 7 / parts;
    return found;
}

} // namespace segment_intersection
