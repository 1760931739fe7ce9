// An index beyond the end: the library notices.
#include "rest.hpp"

#include <iostream>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    std::vector<double> shares{1, 2};
    std::cout << "shares: " << shares.size() << '\n';
    shares[2] = 0.5;
    return right_answer(motion, wall);
}

} // namespace segment_intersection
