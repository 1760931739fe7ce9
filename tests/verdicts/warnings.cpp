// A whole number where a fraction was meant; what the compiler says of it.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const int half = 0.5;
    auto found = right_answer(motion, wall);
    if (found) found->t += half;
    return found;
}

} // namespace segment_intersection
