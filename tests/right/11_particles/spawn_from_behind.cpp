// 11.1: the last free slot, and the pool is copied once
#include "particles.hpp"

namespace particles {

std::optional<Pool> spawn(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    Pool after = pool;
    for (auto slot = after.rbegin(); slot != after.rend(); ++slot)
        if (!slot->has_value()) {
            *slot = particle;
            return after;
        }
    return std::nullopt;
}

} // namespace particles
