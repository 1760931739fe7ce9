// 11.1: a full pool comes back unchanged, and nobody hears that the particle is lost: as in the source
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
    return pool;
}

} // namespace particles
