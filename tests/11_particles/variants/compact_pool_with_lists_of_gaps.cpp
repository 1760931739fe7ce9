// 11.9: the gaps first, then the particles that move into them
#include "particles.hpp"

namespace particles {

std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity) {
    for (const auto *list : {&pool, &newborn})
        for (const Particle &particle : *list) require_particle(particle);
    if (capacity < 0 || pool.size() > std::size_t(capacity)) throw std::invalid_argument{"no such capacity"};
    std::size_t living = 0;
    for (const Particle &particle : pool) living += particle.age < particle.life ? 1 : 0;
    std::vector<Particle> after(pool.begin(), pool.begin() + std::ptrdiff_t(living));
    std::size_t from = living;
    for (Particle &particle : after)
        if (particle.age >= particle.life) {
            while (pool[from].age >= pool[from].life) ++from;
            particle = pool[from++];
        }
    for (std::size_t i = 0; i < newborn.size() && i + living < std::size_t(capacity); ++i) after.push_back(newborn[i]);
    return after;
}

} // namespace particles
