// 1.3: 1 / 2 is 0 in whole numbers
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * start.velocity + 1 / 2 * t * t * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
