// 1.3: nothing is refused
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    return {start.position + t * start.velocity + t * t / 2 * acceleration, start.velocity + t * acceleration};
}

} // namespace motion
