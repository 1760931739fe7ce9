// 11.6: made for an emitter at rest at the origin, then moved
#include "particles.hpp"

namespace particles {

Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers) {
    const Emitter &e = emitter;
    if (e.offset < 0 || e.jitter < 0 || e.min_life <= 0 || e.max_life < e.min_life || random_numbers.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five random_numbers"};
    for (const double c : random_numbers)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"not a random number"};
    std::vector<double> sides;
    for (const double number : random_numbers) sides.push_back(number < 0.5 ? -(1 - 2 * number) : 2 * (number - 0.5));
    Particle particle{.position = {sides[0], sides[1]}, .velocity = {sides[2], sides[3]}, .age = 0, .life = 0};
    particle.position *= e.offset;
    particle.velocity *= e.jitter;
    particle.position += e.position;
    particle.velocity += e.velocity;
    particle.life = (e.min_life + e.max_life) / 2 + sides[4] * (e.max_life - e.min_life) / 2;
    return particle;
}

} // namespace particles
