// 11.6: each field by itself, from its smallest value to its largest
#include "particles.hpp"

namespace particles {

Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    const Emitter &e = emitter;
    course::require_range(e.position, e.velocity, e.offset, e.jitter, e.shortest, e.longest);
    if (e.offset < 0 || e.jitter < 0 || e.shortest <= 0 || e.longest < e.shortest || chances.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five chances"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    const auto between = [](double low, double high, double chance) { return low + chance * (high - low); };
    Particle particle;
    particle.position.x() = between(e.position.x() - e.offset, e.position.x() + e.offset, chances[0]);
    particle.position.y() = between(e.position.y() - e.offset, e.position.y() + e.offset, chances[1]);
    particle.velocity.x() = between(e.velocity.x() - e.jitter, e.velocity.x() + e.jitter, chances[2]);
    particle.velocity.y() = between(e.velocity.y() - e.jitter, e.velocity.y() + e.jitter, chances[3]);
    particle.life = between(e.shortest, e.longest, chances[4]);
    return particle;
}

} // namespace particles
