// 11.5: two chances for x and y: the corners are outside of the disc
#include "particles.hpp"

namespace particles {

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
        velocities.push_back(fastest * Vec2{2 * chances[i] - 1, 2 * chances[i + 1] - 1});
    }
    return velocities;
}

} // namespace particles
