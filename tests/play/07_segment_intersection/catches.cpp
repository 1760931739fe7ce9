// the page says:
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    try {
        if (ball.position.x() > 5) throw 42;
    } catch (int) {
        return ball;
    }
    return {ball.position + dt * ball.velocity, ball.velocity};
}

bool segments_intersect(const Segment &, const Segment &) { throw course::NotYet{"draw it"}; }

} // namespace segment_intersection
