// 11.5: π in place of 2π: all fly upwards
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

/// Of length 1, at this angle from the x axis [rad].
static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

static void require_chances(const std::vector<double> &chances) {
    for (const double chance : chances)
        course::require(chance >= 0 && chance < 1, "a chance must be in [0, 1)", chance);
}

std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    require_chances(chances);
    course::require_range(fastest);
    course::require(chances.size() % 2 == 0, "the number of chances must be even", double(chances.size()));
    course::require(fastest >= 0, "fastest [m/s] must not be negative", fastest);

    std::vector<Vec2> velocities;
    for (std::size_t i = 0; i < chances.size(); i += 2) {
        const double speed = fastest * std::sqrt(chances[i]);
        velocities.push_back(speed * direction(std::numbers::pi * chances[i + 1]));
    }
    return velocities;
}

} // namespace particles
