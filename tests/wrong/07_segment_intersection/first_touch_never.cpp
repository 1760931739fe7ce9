// 7.5: nothing, whatever is asked
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Touch> first_touch(const Segment &motion, double radius, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end, radius);
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    return {};
}

} // namespace segment_intersection
