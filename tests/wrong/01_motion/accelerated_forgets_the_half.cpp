// 1.3: a t² instead of a t²/2
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * start.velocity + t * t * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
