// 11.6: weights for the two ends: (1 - chance) and chance
#include "particles.hpp"

namespace particles {

Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    const Emitter &e = emitter;
    course::require_range(e.position, e.velocity, e.offset, e.jitter, e.shortest, e.longest);
    if (e.offset < 0 || e.jitter < 0 || e.shortest <= 0 || e.longest < e.shortest || chances.size() != 5)
        throw std::invalid_argument{"no such emitter, or not five chances"};
    for (const double c : chances)
        if (!(c >= 0 && c < 1)) throw std::invalid_argument{"no chance"};
    const Vec2 place{chances[0] - 0.5, chances[1] - 0.5}, speed{chances[2] - 0.5, chances[3] - 0.5};
    return {e.position + 2 * e.offset * place, e.velocity + 2 * e.jitter * speed, 0,
            (1 - chances[4]) * e.shortest + chances[4] * e.longest};
}

} // namespace particles
