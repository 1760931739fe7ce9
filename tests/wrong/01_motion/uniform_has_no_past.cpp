// 1.2: before t = 0 it stood still
#include "motion.hpp"

#include <algorithm>

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return start + std::max(t, 0.0) * velocity;
}

} // namespace motion
