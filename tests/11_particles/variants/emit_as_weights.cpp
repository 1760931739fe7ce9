// 11.6: weights for the two ends: (1 - number) and number
#include "particles.hpp"

namespace particles {

Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers) {
    const Emitter &e = emitter;
    if (e.offset < 0 || e.jitter < 0 || e.min_life <= 0 || e.max_life < e.min_life || random_numbers.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five random_numbers"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    const Vec2 place{random_numbers[0] - 0.5, random_numbers[1] - 0.5},
        speed{random_numbers[2] - 0.5, random_numbers[3] - 0.5};
    return {e.position + 2 * e.offset * place, e.velocity + 2 * e.jitter * speed, 0,
            (1 - random_numbers[4]) * e.min_life + random_numbers[4] * e.max_life};
}

} // namespace particles
