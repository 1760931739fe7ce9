// 1.3: half the time, twice
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    State now = start;
    for (int half = 0; half < 2; ++half) {
        now.position += t / 2 * now.velocity + t * t / 8 * acceleration;
        now.velocity += t / 2 * acceleration;
    }
    return now;
}

} // namespace motion
