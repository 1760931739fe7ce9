// the page says: 7.4 move_and_bounce was stopped by a check of the library that it uses:
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    Eigen::VectorXd three(3);
    volatile int k = 7;
    if (ball.position.x() > 5 && three[k] > 0) return ball;
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
