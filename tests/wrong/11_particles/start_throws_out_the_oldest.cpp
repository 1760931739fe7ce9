// 11.1: where no slot is free, the one in the first slot has to go
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    if (pool.empty()) return {};
    Pool after = pool;
    after[0] = particle;
    return after;
}

} // namespace particles
