// 11.1: the particle goes into a copy of the slot
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            auto slot = pool[i];
            slot = particle;
            return pool;
        }
    return {};
}

} // namespace particles
