// Whole numbers where fractions were meant: what the compiler says of one, and the course of the other.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const int half = 0.5;
    auto found = right_answer(motion, wall);
    if (found) found->t += half + 1 / 2;
    return found;
}

} // namespace segment_intersection
