// 1.2: only the way
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return t * velocity;
}

} // namespace motion
