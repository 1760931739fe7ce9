// A gigabyte of output.
#include "rest.hpp"

#include <iostream>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    for (int i = 0; i < 20'000'000; ++i) std::cout << "I am at step " << i << " of very many steps\n";
    return right_answer(motion, wall);
}

} // namespace segment_intersection
