// the page says: 7.4 move_and_bounce was stopped by a check of the library that it uses: vector[] index out of bounds.
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    volatile std::size_t corner = 700;
    if (ball.position.x() > 5 && room[corner].x() > 0) return ball;
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
