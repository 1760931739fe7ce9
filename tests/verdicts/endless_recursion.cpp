// A function that calls itself, and never stops.
#include "rest.hpp"

namespace segment_intersection {

double deeper(double x) { return x > 0 ? 1 + deeper(x + 1) * 0.5 : 0; }

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    auto found = right_answer(motion, wall);
    if (found) found->t += deeper(1);
    return found;
}

} // namespace segment_intersection
