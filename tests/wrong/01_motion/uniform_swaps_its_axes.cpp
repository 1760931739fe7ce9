// 1.2: x with the velocity of y
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return Vec2{start.x() + t * velocity.y(), start.y() + t * velocity.x()};
}

} // namespace motion
