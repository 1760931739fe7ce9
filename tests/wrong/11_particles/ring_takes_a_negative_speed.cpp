// 11.4: backwards is a speed as well
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

/// Of length 1, at this angle from the x axis [rad].
static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

std::vector<Vec2> ring(int count, double speed, double first) {
    course::require_range(speed, first);
    course::require(count >= 0, "count must not be negative", count);

    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count;
        velocities.push_back(speed * direction(first + 2 * std::numbers::pi * turn));
    }
    return velocities;
}

} // namespace particles
