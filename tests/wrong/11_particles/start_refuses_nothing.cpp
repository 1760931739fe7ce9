// 11.1: a particle that is nowhere starts all the same
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
