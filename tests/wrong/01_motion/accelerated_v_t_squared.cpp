// 1.3: the first velocity counts with t²
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * t * start.velocity + t * t / 2 * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
