// 11.1: what lives moves to the front, and slots are no longer where they were
#include "particles.hpp"

namespace particles {

std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after;
            for (const auto &slot : pool)
                if (slot) after.push_back(slot);
            after.push_back(particle);
            after.resize(pool.size());
            return after;
        }
    return {};
}

} // namespace particles
