// 1.3: x and y separately
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    State after = start;
    for (const int axis : {0, 1}) {
        after.position[axis] += (start.velocity[axis] + acceleration[axis] * t / 2) * t;
        after.velocity[axis] += acceleration[axis] * t;
    }
    return after;
}

} // namespace motion
