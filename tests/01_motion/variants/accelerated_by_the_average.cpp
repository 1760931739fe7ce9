// 1.3: at the average of the first and the last velocity
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    const Vec2 last = start.velocity + t * acceleration;
    return {start.position + t * (start.velocity + last) / 2, last};
}

} // namespace motion
