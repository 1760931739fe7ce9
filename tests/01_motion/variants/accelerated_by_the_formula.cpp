// 1.3: x_0 + v_0 t + a t²/2, as it is printed
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    return {start.position + start.velocity * t + 0.5 * acceleration * t * t, start.velocity + acceleration * t};
}

} // namespace motion
