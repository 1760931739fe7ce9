// 11.5: the root of r² = number · max_speed²
#include "particles.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace particles {

std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed) {
    if (max_speed < 0 || random_numbers.size() % 2 != 0) throw std::invalid_argument{"no such burst"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    std::vector<Vec2> velocities;
    for (std::size_t i = 0; i < random_numbers.size(); i += 2) {
        const auto v = std::polar(std::sqrt(random_numbers[i] * max_speed * max_speed),
                                  2 * std::numbers::pi * random_numbers[i + 1]);
        velocities.emplace_back(v.real(), v.imag());
    }
    return velocities;
}

} // namespace particles
