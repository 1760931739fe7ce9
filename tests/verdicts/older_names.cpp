// An answer from before its functions got the names of today.
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    const Vec2 way = motion.end - motion.start;
    if (way.norm() < parallel) return {};
    return Crossing{0, 0, wall.start};
}

} // namespace segment_intersection
