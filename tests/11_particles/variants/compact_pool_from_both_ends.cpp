// 11.9: one index looks for gaps from the front, the other for the living from the back
#include "particles.hpp"

namespace particles {

std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity) {
    for (const auto *list : {&pool, &newborn})
        for (const Particle &particle : *list) require_particle(particle);
    if (capacity < 0 || pool.size() > std::size_t(capacity)) throw std::invalid_argument{"no such capacity"};
    std::vector<Particle> after = pool;
    const auto lives = [&](std::size_t i) { return after[i].age < after[i].life; };
    std::size_t front = 0, back = after.size();
    while (true) {
        while (front < back && lives(front)) ++front;
        while (front < back && !lives(back - 1)) --back;
        if (front >= back) break;
        after[front++] = after[--back];
    }
    after.resize(front);
    for (const Particle &particle : newborn)
        if (after.size() < std::size_t(capacity)) after.push_back(particle);
    return after;
}

} // namespace particles
