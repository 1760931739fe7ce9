// 11.1: it throws the dead out on its way, which is not its job: they are not looked at
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i] || pool[i]->age >= pool[i]->life || pool[i]->life <= 0) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

} // namespace particles
