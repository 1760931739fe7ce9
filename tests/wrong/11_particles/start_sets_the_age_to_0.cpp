// 11.1: the particle must begin with age 0, it thinks; but it goes in as it is
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            after[i]->age = 0;
            return after;
        }
    return {};
}

} // namespace particles
