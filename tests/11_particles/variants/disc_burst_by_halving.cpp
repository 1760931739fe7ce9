// 11.5: the speed below which that fraction of the area lies, found by bisection
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed) {
    if (max_speed < 0 || random_numbers.size() % 2 != 0) throw std::invalid_argument{"no such burst"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    std::vector<Vec2> velocities(random_numbers.size() / 2);
    for (std::size_t k = 0; k < velocities.size(); ++k) {
        double low = 0, high = 1;
        for (int i = 0; i < 70; ++i) {
            const double middle = (low + high) / 2;
            (middle * middle < random_numbers[2 * k] ? low : high) = middle;
        }
        const double angle = 2 * std::numbers::pi * random_numbers[2 * k + 1];
        velocities[k] = {max_speed * low * std::cos(angle), max_speed * low * std::sin(angle)};
    }
    return velocities;
}

} // namespace particles
