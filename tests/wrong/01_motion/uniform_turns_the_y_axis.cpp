// 1.2: y as on a screen
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return Vec2{start.x() + t * velocity.x(), start.y() - t * velocity.y()};
}

} // namespace motion
