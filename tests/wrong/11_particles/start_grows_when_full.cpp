// 11.1: where no slot is free it makes one
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
    Pool after = pool;
    after.push_back(particle);
    return after;
}

} // namespace particles
