// 1.3: nothing accelerates along y
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    return {{start.position.x() + t * start.velocity.x() + t * t / 2 * acceleration.x(),
             start.position.y() + t * start.velocity.y()},
            {start.velocity.x() + t * acceleration.x(), start.velocity.y()}};
}

} // namespace motion
