// A pointer to nothing.
#include "rest.hpp"

namespace segment_intersection {

LineIntersection *last = nullptr;

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    *last = *right_answer(motion, wall);
    return *last;
}

} // namespace segment_intersection
