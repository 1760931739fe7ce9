// 1.3: the gained velocity moves nothing
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * start.velocity, start.velocity + t * acceleration};
}

} // namespace motion
