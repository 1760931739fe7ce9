// 11.9: i goes on after each gap: who was moved into it is not looked at
#include "particles.hpp"

namespace particles {

std::vector<Particle> renew(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity) {
    for (const Particle &particle : pool) require_particle(particle);
    for (const Particle &particle : newborn) require_particle(particle);
    course::require(capacity >= 0, "capacity must not be negative", capacity);
    const auto most = std::size_t(capacity);
    course::require(pool.size() <= most, "capacity must not be less than the pool holds", capacity);

    std::vector<Particle> after = pool;
    for (std::size_t i = 0; i < after.size();) {
        if (after[i].age < after[i].life) {
            ++i;
        } else {
            after[i] = after.back();
            after.pop_back();
            ++i;
        }
    }
    for (std::size_t i = 0; i < newborn.size() && after.size() < most; ++i) after.push_back(newborn[i]);
    return after;
}

} // namespace particles
