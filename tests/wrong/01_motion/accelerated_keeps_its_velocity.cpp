// 1.3: the velocity stays as it was
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * start.velocity + t * t / 2 * acceleration, start.velocity};
}

} // namespace motion
