// 11.1: off by one: it overwrites the neighbour of the free slot
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i == 0 ? 0 : i - 1] = particle;
            return after;
        }
    return {};
}

} // namespace particles
