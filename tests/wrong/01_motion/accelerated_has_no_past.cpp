// 1.3: back in time it runs forwards
#include "motion.hpp"

#include <cmath>

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    const double s = std::abs(t);
    return {start.position + s * start.velocity + s * s / 2 * acceleration, start.velocity + s * acceleration};
}

} // namespace motion
