// 1.3: a t/2: the square is missing
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * start.velocity + t / 2 * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
