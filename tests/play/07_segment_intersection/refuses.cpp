// the page says: 7.4 move_and_bounce refused its input: x [m] must be below 5, but is 5.
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(ball.position.x() < 5, "x [m] must be below 5", ball.position.x());
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
