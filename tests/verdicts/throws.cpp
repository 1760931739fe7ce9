// An exception that is no refusal.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    throw std::runtime_error{"I give up"};
}

} // namespace segment_intersection
