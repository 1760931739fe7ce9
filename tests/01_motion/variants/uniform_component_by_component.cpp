// 1.2: x and y separately
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    return {start.x() + velocity.x() * t, start.y() + velocity.y() * t};
}

} // namespace motion
