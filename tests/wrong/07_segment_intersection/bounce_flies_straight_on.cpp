// 7.4: no walls at all: position + velocity dt
#include "segment_intersection.hpp"

namespace segment_intersection {

Mover bounce(const Mover &mover, const std::vector<Vec2> &room, double dt) {
    course::require_range(room);
    course::require_range(mover.position, mover.velocity, dt);
    course::require(dt >= 0 && room.size() >= 3, "time and room must make sense", dt);
    for (std::size_t i = 0; i < room.size(); ++i)
        course::require(room[i] != room[(i + 1) % room.size()], "the length of a wall [m] must be positive", 0);
    return {mover.position + dt * mover.velocity, mover.velocity};
}

} // namespace segment_intersection
