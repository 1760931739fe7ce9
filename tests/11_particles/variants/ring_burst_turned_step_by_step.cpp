// 11.4: each velocity is the one before, turned by the angle between neighbours
#include "particles.hpp"

#include <cmath>
#include <numbers>

namespace particles {

std::vector<Vec2> ring_burst(int count, double speed, double first) {
    if (count < 0 || speed < 0) throw std::invalid_argument{"no such ring"};
    if (count == 0) return {};
    const double gap = 2 * std::numbers::pi / count;
    std::vector<Vec2> velocities{speed * Vec2{std::cos(first), std::sin(first)}};
    while (velocities.size() < std::size_t(count)) {
        const Vec2 v = velocities.back();
        velocities.emplace_back(std::cos(gap) * v.x() - std::sin(gap) * v.y(),
                                std::sin(gap) * v.x() + std::cos(gap) * v.y());
    }
    return velocities;
}

} // namespace particles
