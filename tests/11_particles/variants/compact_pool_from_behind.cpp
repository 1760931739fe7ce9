// 11.9: from the last to the first: a particle that fills a gap has already been looked at
#include "particles.hpp"

#include <algorithm>
#include <utility>

namespace particles {

std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity) {
    for (const auto *list : {&pool, &newborn})
        for (const Particle &particle : *list) require_particle(particle);
    if (capacity < 0 || pool.size() > std::size_t(capacity)) throw std::invalid_argument{"no such capacity"};
    std::vector<Particle> after = pool;
    for (std::size_t i = after.size(); i-- > 0;)
        if (after[i].age >= after[i].life) {
            std::swap(after[i], after.back());
            after.pop_back();
        }
    const std::size_t fit = std::min(newborn.size(), std::size_t(capacity) - after.size());
    after.insert(after.end(), newborn.begin(), newborn.begin() + std::ptrdiff_t(fit));
    return after;
}

} // namespace particles
