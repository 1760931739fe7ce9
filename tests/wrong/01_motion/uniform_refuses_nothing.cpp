// 1.2: nothing is refused
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) { return start + t * velocity; }

} // namespace motion
