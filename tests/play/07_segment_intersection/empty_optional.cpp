// the page says: 7.4 move_and_bounce
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    std::optional<double> none;
    if (ball.position.x() > 5 && none.value() > 0) return ball;
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
