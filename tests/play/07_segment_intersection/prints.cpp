// the page says: 7.4 move_and_bounce threw std::logic_error: printed
#include "segment_intersection.hpp"

#include <iostream>

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    std::cout << "here " << dt << std::endl;
    if (ball.position.x() > 5) throw std::logic_error{"printed"};
    return {ball.position + dt * ball.velocity, ball.velocity};
}

} // namespace segment_intersection
