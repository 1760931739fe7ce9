// the page says: 7.4 move_and_bounce called itself, again and again, until the stack was full.
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    if (ball.position.x() <= 5) return {ball.position + dt * ball.velocity, ball.velocity};
    Ball next = move_and_bounce(ball, room, dt);
    next.position.x() += 1;
    return next;
}

} // namespace segment_intersection
