// 11.1: it goes on after the first free slot, and the particle is there many times
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    Pool after = pool;
    bool found = false;
    for (auto &slot : after)
        if (!slot) {
            slot = particle;
            found = true;
        }
    if (!found) return {};
    return after;
}

} // namespace particles
