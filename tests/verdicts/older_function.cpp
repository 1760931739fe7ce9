// A function by its old name. Nothing else in the file is older than the header.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> crossing(const Segment &motion, const Segment &wall) {
    return right_answer(motion, wall);
}

} // namespace segment_intersection
