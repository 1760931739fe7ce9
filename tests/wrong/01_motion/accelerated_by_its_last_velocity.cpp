// 1.3: as if it had been so fast all the time
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * (start.velocity + t * acceleration), start.velocity + t * acceleration};
}

} // namespace motion
