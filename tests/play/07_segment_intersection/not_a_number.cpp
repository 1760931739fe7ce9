// the page says: A position is infinite, or not a number (NaN): which function returned it, or which Vec2 did you never set?
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    Vec2 position = ball.position + dt * ball.velocity;
    if (position.x() > 5) position /= 0 * dt;
    return {position, ball.velocity};
}

} // namespace segment_intersection
