// 1.3: in a thousand small steps: nearly
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    State now = start;
    for (int i = 0; i < 1000; ++i) {
        now.position += t / 1000 * now.velocity;
        now.velocity += t / 1000 * acceleration;
    }
    return now;
}

} // namespace motion
