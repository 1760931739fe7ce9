// 11.6: each field by itself, from its smallest value to its largest
#include "particles.hpp"

namespace particles {

Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers) {
    const Emitter &e = emitter;
    if (e.offset < 0 || e.jitter < 0 || e.min_life <= 0 || e.max_life < e.min_life || random_numbers.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five random_numbers"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    const auto between = [](double low, double high, double number) { return low + number * (high - low); };
    Particle particle;
    particle.position.x() = between(e.position.x() - e.offset, e.position.x() + e.offset, random_numbers[0]);
    particle.position.y() = between(e.position.y() - e.offset, e.position.y() + e.offset, random_numbers[1]);
    particle.velocity.x() = between(e.velocity.x() - e.jitter, e.velocity.x() + e.jitter, random_numbers[2]);
    particle.velocity.y() = between(e.velocity.y() - e.jitter, e.velocity.y() + e.jitter, random_numbers[3]);
    particle.life = between(e.min_life, e.max_life, random_numbers[4]);
    return particle;
}

} // namespace particles
