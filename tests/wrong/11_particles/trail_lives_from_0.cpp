// 11.6: life is a share of the longest
#include "particles.hpp"

namespace particles {

static void require_chances(const std::vector<double> &chances) {
    for (const double chance : chances)
        course::require(chance >= 0 && chance < 1, "a chance must be in [0, 1)", chance);
}

/// From -1 to 1.
static double either_way(double chance) { return 2 * chance - 1; }

Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    const auto &[position, velocity, offset, jitter, shortest, longest] = emitter;
    course::require_range(position, velocity, offset, jitter, shortest, longest);
    require_chances(chances);
    course::require(chances.size() == 5, "the number of chances must be 5", double(chances.size()));
    course::require(offset >= 0, "offset [m] must not be negative", offset);
    course::require(jitter >= 0, "jitter [m/s] must not be negative", jitter);
    course::require(shortest > 0, "the shortest life [s] must be positive", shortest);
    course::require(longest >= shortest, "the longest life [s] must not be less than the shortest", longest);

    return {.position = position + offset * Vec2{either_way(chances[0]), either_way(chances[1])},
            .velocity = velocity + jitter * Vec2{either_way(chances[2]), either_way(chances[3])},
            .age = 0,
            .life = longest * chances[4]};
}

} // namespace particles
