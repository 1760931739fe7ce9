// 1.2: a negative time is refused
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    course::require(t >= 0, "t [s] must not be negative", t);
    return start + t * velocity;
}

} // namespace motion
