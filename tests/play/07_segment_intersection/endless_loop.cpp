// the page says: 7.4 move_and_bounce gave no answer: look for a loop that never ends.
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    double x = ball.position.x();
    while (x > 5) x += 1;
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
