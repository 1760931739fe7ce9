// 11.3: it is inside if x / width and y / height are both 0 when rounded down
#include "particles.hpp"

#include <cmath>

namespace particles {

std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    if (world.width <= 0 || world.height <= 0 || dt < 0) throw std::invalid_argument{"no such world or time"};
    Particle next = particle;
    next.velocity.x() += dt * world.wind;
    next.velocity.y() -= dt * world.gravity;
    next.position += next.velocity * dt;
    next.age += dt;
    const bool left_over =
        std::floor(next.position.x() / world.width) != 0 || std::floor(next.position.y() / world.height) != 0;
    if (left_over || !(next.age < next.life)) return std::nullopt;
    return next;
}

} // namespace particles
