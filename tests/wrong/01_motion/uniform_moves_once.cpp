// 1.2: one frame, however long
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return start + velocity;
}

} // namespace motion
