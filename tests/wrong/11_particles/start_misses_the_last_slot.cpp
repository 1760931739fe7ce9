// 11.1: i < size - 1: the last slot is never used
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i + 1 < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
