// A list that grows for ever.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    std::vector<Vec2> path;
    for (;;) path.push_back(motion.start);
    return right_answer(motion, wall);
}

} // namespace segment_intersection
