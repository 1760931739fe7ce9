// A loop that never ends.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    for (volatile int i = 0; i < 10;) static_cast<void>(motion);
    return right_answer(motion, wall);
}

} // namespace segment_intersection
