// 1.2: frames of a thirtieth of a second, as many as fit
#include "motion.hpp"

#include <cmath>

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return start + std::floor(t * 30) / 30 * velocity;
}

} // namespace motion
