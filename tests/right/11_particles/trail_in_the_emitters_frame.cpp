// 11.6: made at rest at the origin, then taken along
#include "particles.hpp"

namespace particles {

Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    const Emitter &e = emitter;
    course::require_range(e.position, e.velocity, e.offset, e.jitter, e.shortest, e.longest);
    if (e.offset < 0 || e.jitter < 0 || e.shortest <= 0 || e.longest < e.shortest || chances.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five chances"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    std::vector<double> sides;
    for (const double chance : chances) sides.push_back(chance < 0.5 ? -(1 - 2 * chance) : 2 * (chance - 0.5));
    Particle particle{.position = {sides[0], sides[1]}, .velocity = {sides[2], sides[3]}, .age = 0, .life = 0};
    particle.position *= e.offset;
    particle.velocity *= e.jitter;
    particle.position += e.position;
    particle.velocity += e.velocity;
    particle.life = (e.shortest + e.longest) / 2 + sides[4] * (e.longest - e.shortest) / 2;
    return particle;
}

} // namespace particles
