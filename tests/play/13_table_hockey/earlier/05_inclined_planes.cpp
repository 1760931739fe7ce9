// One that never ends.
#include "inclined_planes.hpp"

double of_the_same_name(double x) { return 2 * x; }

namespace inclined_planes {

Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt) {
    double left = of_the_same_name(dt);
    while (left > 0) left += deceleration;
    return velocity;
}

} // namespace inclined_planes
