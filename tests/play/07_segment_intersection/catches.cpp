// the page says: 7.4 move_and_bounce threw a number. In a page no `catch` can take that.
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

} // namespace segment_intersection
