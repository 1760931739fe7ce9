// 7.1: in homogeneous coordinates, counted from the motion's start: a line is the cross product of two points
#include "segment_intersection.hpp"

namespace segment_intersection {

using Vec3 = Eigen::Vector3d;

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const Vec2 a = motion.end - motion.start, b = wall.end - wall.start;
    const Vec3 motion_line{-a.y(), a.x(), 0}; // through (0, 0)
    const Vec3 wall_line = (wall.start - motion.start).homogeneous().cross((wall.end - motion.start).homogeneous());
    const Vec3 meeting = motion_line.cross(wall_line);
    if (std::abs(meeting.z()) <= parallel_tolerance * a.norm() * b.norm()) return {};

    const Vec2 walked = meeting.hnormalized();
    const Vec2 point = motion.start + walked;
    return LineIntersection{walked.dot(a) / a.squaredNorm(), (point - wall.start).dot(b) / b.squaredNorm(), point};
}

} // namespace segment_intersection
