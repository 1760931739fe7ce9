// 11.1: counted from 1: the first slot is never used
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 1; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
