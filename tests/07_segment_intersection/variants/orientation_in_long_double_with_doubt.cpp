// 7.6: differences and products with more digits, so that less doubt remains
#include "segment_intersection.hpp"

#include <limits>

namespace segment_intersection {

int orientation(const Segment &first, const Segment &second) {
    using Vector = Eigen::Matrix<long double, 2, 1>;
    const Vector a = first.end.cast<long double>() - first.start.cast<long double>();
    const Vector b = second.end.cast<long double>() - second.start.cast<long double>();
    const long double left = a.x() * b.y(), right = a.y() * b.x();
    const long double digits = std::numeric_limits<long double>::epsilon(); // on some machines no more than a double's
    const long double doubt = 2.3L * digits * (std::abs(left) + std::abs(right)) + 1e-301L;
    return left - right > doubt ? 1 : left - right < -doubt ? -1 : 0;
}

} // namespace segment_intersection
