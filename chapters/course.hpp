#pragma once
// What every section shares, and every student's file compiles: keep it small.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <sstream>
#include <stdexcept>

namespace course {

using Vec2 = Eigen::Vector2d; ///< x to the right, y up; metres unless said otherwise

/// Thrown by an exercise that has not been started; what() says where to begin.
/// The tests report it as "not started". It is no std::invalid_argument, so no refusal is taken for it.
struct NotYet : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Refuses a value, and says which: `require(radius > 0, "radius [m] must be positive", radius)`.
/// @throws std::invalid_argument "radius [m] must be positive, but is -1"
inline void require(bool holds, const char *claim, double value) {
    if (holds) return;
    std::ostringstream message;
    message.precision(17);
    message << claim << ", but is " << value;
    throw std::invalid_argument{message.str()};
}

} // namespace course
