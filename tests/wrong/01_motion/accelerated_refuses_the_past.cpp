// 1.3: a negative time is refused
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    course::require(t >= 0, "t [s] must not be negative", t);
    return {start.position + t * start.velocity + t * t / 2 * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
