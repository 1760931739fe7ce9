// 7.1: y = m x + c, as at school; an upright line has no m
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const double m_1 = a.y() / a.x(), m_2 = b.y() / b.x();
    const double c_1 = motion.start.y() - m_1 * motion.start.x(), c_2 = wall.start.y() - m_2 * wall.start.x();

    if (std::abs(a.x() * b.y() - a.y() * b.x()) <= parallel * a.norm() * b.norm()) return {};
    const double x = (c_2 - c_1) / (m_1 - m_2);
    return Crossing{(x - motion.start.x()) / a.x(), (x - wall.start.x()) / b.x(), {x, m_1 * x + c_1}};
}

} // namespace segment_intersection
