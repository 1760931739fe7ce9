// 11.1: all free slots are listed first, and the middle one is taken
#include "particles.hpp"

namespace particles {

std::optional<Pool> spawn(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i].has_value()) free.push_back(i);
    if (free.empty()) return {};
    std::optional<Pool> after = pool;
    (*after)[free[free.size() / 2]] = particle;
    return after;
}

} // namespace particles
