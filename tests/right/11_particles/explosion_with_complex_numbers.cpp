// 11.5: the root of r² = chance · fastest²
#include "particles.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace particles {

std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    course::require_range(fastest);
    if (fastest < 0 || chances.size() % 2 != 0) throw std::invalid_argument{"no such explosion"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    std::vector<Vec2> velocities;
    for (std::size_t i = 0; i < chances.size(); i += 2) {
        const auto v = std::polar(std::sqrt(chances[i] * fastest * fastest), 2 * std::numbers::pi * chances[i + 1]);
        velocities.emplace_back(v.real(), v.imag());
    }
    return velocities;
}

} // namespace particles
