// 11.5: the angle from -1/2 to 1/2 of a turn, and a power in place of the root
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed) {
    if (max_speed < 0 || random_numbers.size() % 2 != 0) throw std::invalid_argument{"no such burst"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    std::vector<Vec2> velocities;
    for (std::size_t k = 0; 2 * k < random_numbers.size(); ++k) {
        const double turn = random_numbers[2 * k + 1] < 0.5 ? random_numbers[2 * k + 1] : random_numbers[2 * k + 1] - 1;
        const Vec2 right{max_speed * std::pow(random_numbers[2 * k], 0.5), 0};
        velocities.push_back(Eigen::Rotation2D<double>{2 * std::numbers::pi * turn} * right);
    }
    return velocities;
}

} // namespace particles
