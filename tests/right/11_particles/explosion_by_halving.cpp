// 11.5: the speed below which the chance's share of the area lies, found by halving
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    course::require_range(fastest);
    if (fastest < 0 || chances.size() % 2 != 0) throw std::invalid_argument{"no such explosion"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    std::vector<Vec2> velocities(chances.size() / 2);
    for (std::size_t k = 0; k < velocities.size(); ++k) {
        double low = 0, high = 1;
        for (int i = 0; i < 70; ++i) {
            const double middle = (low + high) / 2;
            (middle * middle < chances[2 * k] ? low : high) = middle;
        }
        const double angle = 2 * std::numbers::pi * chances[2 * k + 1];
        velocities[k] = {fastest * low * std::cos(angle), fastest * low * std::sin(angle)};
    }
    return velocities;
}

} // namespace particles
