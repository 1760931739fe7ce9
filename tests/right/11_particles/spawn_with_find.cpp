// 11.1: std::find for an empty slot
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<Pool> spawn(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    Pool after = pool;
    const auto free = std::find_if(after.begin(), after.end(), [](const auto &slot) { return !slot; });
    if (free == after.end()) return {};
    free->emplace(particle);
    return after;
}

} // namespace particles
