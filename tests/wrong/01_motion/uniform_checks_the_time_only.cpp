// 1.2: only the time is checked
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(t);
    return start + t * velocity;
}

} // namespace motion
