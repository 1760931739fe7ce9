// Good input is accepted, but not what the code makes of it: within ±1e5, two corners are up to 2e5 apart.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    course::require_range(Vec2{motion.end - motion.start});
    return right_answer(motion, wall);
}

} // namespace segment_intersection
