// 1.3: its first velocity is forgotten
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {start.position + t * t / 2 * acceleration, t * acceleration};
}

} // namespace motion
