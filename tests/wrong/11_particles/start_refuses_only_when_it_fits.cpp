// 11.1: a full pool says so before it has looked at the particle
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            require_particle(particle);
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
