// t and s have changed places.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    auto found = right_answer(motion, wall);
    if (found) std::swap(found->t, found->s);
    return found;
}

} // namespace segment_intersection
