// the page says:
#include "segment_intersection.hpp"

namespace segment_intersection {

// It flies on through walls, and 7.2 is not started.
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &, double dt) {
    return {ball.position + dt * ball.velocity, ball.velocity};
}

bool segments_intersect(const Segment &, const Segment &) { throw course::NotYet{"draw it"}; }

} // namespace segment_intersection
