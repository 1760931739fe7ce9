// 7.1: seven digits, as in most engines
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Eigen::Vector2f a = (motion.end - motion.start).cast<float>();
    const Eigen::Vector2f b = (wall.end - wall.start).cast<float>();
    const Eigen::Vector2f gap = (wall.start - motion.start).cast<float>();

    const float d = a.x() * b.y() - a.y() * b.x();
    if (std::abs(d) <= float(parallel) * a.norm() * b.norm()) return {};
    const double t = double((gap.x() * b.y() - gap.y() * b.x()) / d);
    const double s = double((gap.x() * a.y() - gap.y() * a.x()) / d);
    return Crossing{t, s, motion.start + t * (motion.end - motion.start)};
}

} // namespace segment_intersection
