// Output without an end. A thousand lines at a time: a write can cost so much that one for each line meets the limit of time
// first.
#include "rest.hpp"

#include <iostream>
#include <string>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    std::string steps;
    for (int i = 0; i < 1000; ++i) steps += "I am at step " + std::to_string(i) + " of very many steps\n";
    for (int i = 0; i < 20'000; ++i) std::cout << steps;
    return right_answer(motion, wall);
}

} // namespace segment_intersection
