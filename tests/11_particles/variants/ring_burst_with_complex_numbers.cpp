// 11.4: std::polar makes a point of a length and an angle
#include "particles.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace particles {

std::vector<Vec2> ring_burst(int count, double speed, double first) {
    if (count < 0 || speed < 0) throw std::invalid_argument{"no such ring"};
    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const auto v = std::polar(speed, first + i * (2 * std::numbers::pi / count));
        velocities.emplace_back(v.real(), v.imag());
    }
    return velocities;
}

} // namespace particles
