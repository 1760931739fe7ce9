// 11.4: Eigen turns the first one
#include "particles.hpp"

#include <numbers>

namespace particles {

std::vector<Vec2> ring_burst(int count, double speed, double first) {
    if (count < 0 || speed < 0) throw std::invalid_argument{"no such ring"};
    std::vector<Vec2> velocities(std::size_t(count), Vec2{speed, 0});
    for (int i = 0; i < count; ++i) {
        const Vec2 v = velocities[std::size_t(i)];
        velocities[std::size_t(i)] = Eigen::Rotation2D<double>{first + 2 * std::numbers::pi * i / count} * v;
    }
    return velocities;
}

} // namespace particles
