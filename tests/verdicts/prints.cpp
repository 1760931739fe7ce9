// Words for the author, escape codes among them, on the way to a wrong answer.
#include "rest.hpp"

#include <iostream>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    std::cout << "\x1b[31mmotion\x1b[0m starts at " << motion.start.transpose() << '\n';
    std::cerr << "no line end";
    auto found = right_answer(motion, wall);
    if (found) found->s = 7;
    return found;
}

} // namespace segment_intersection
