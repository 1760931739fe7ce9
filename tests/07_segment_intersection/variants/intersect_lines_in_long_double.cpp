// 7.1: more digits, and the sine squared in place of the sine
#include "segment_intersection.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    using Vector = Eigen::Matrix<long double, 2, 1>;
    const Vector from = motion.start.cast<long double>(), to = wall.start.cast<long double>();
    const Vector a = motion.end.cast<long double>() - from, b = wall.end.cast<long double>() - to, gap = to - from;
    const auto det = [](const Vector &u, const Vector &v) { return u.x() * v.y() - u.y() * v.x(); };

    const long double d = det(a, b);
    if (d * d <= 1e-24L * a.squaredNorm() * b.squaredNorm()) return {};
    const long double t = det(gap, b) / d, s = det(gap, a) / d;
    return LineIntersection{double(t), double(s), (from + t * a).cast<double>()};
}

} // namespace segment_intersection
