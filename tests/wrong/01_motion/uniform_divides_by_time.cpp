// 1.2: a speed is a way by a time, so divided again
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    course::require_range(start, velocity, t);
    return t == 0 ? start : Vec2{start + velocity / t};
}

} // namespace motion
