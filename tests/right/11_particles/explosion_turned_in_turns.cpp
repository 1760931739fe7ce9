// 11.5: the angle from -1/2 to 1/2 of a turn, and a power in place of the root
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    course::require_range(fastest);
    if (fastest < 0 || chances.size() % 2 != 0) throw std::invalid_argument{"no such explosion"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    std::vector<Vec2> velocities;
    for (std::size_t k = 0; 2 * k < chances.size(); ++k) {
        const double turn = chances[2 * k + 1] < 0.5 ? chances[2 * k + 1] : chances[2 * k + 1] - 1;
        const Vec2 right{fastest * std::pow(chances[2 * k], 0.5), 0};
        velocities.push_back(Eigen::Rotation2D<double>{2 * std::numbers::pi * turn} * right);
    }
    return velocities;
}

} // namespace particles
