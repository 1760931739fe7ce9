// 1.2: interpolates between its positions now and one second later
#include "motion.hpp"

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    const Vec2 next = start + velocity;
    return (1 - t) * start + t * next;
}

} // namespace motion
