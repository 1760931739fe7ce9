// 11.1: the pool is always full
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i] && pool.size() > 1000000) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
