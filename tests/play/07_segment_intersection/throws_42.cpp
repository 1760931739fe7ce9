// the page says: 7.4 move_and_bounce threw the number 42.
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    if (ball.position.x() > 5) throw 42;
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
