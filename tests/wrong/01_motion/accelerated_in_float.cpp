// 1.3: in float
#include "motion.hpp"

namespace motion {

State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    course::require_range(start.position, start.velocity, acceleration, t);
    const Eigen::Vector2f half = float(t * t / 2) * acceleration.cast<float>();
    const Eigen::Vector2f after = start.position.cast<float>() + float(t) * start.velocity.cast<float>() + half;
    return {after.cast<double>(), start.velocity + t * acceleration};
}

} // namespace motion
