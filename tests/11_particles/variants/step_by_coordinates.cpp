// 11.3: x and y one by one, and the refusals first
#include "particles.hpp"

namespace particles {

std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    if (world.width <= 0 || world.height <= 0 || dt < 0) throw std::invalid_argument{"no such world or time"};
    const double vx = particle.velocity.x() + world.wind * dt, vy = particle.velocity.y() - world.gravity * dt;
    const double x = particle.position.x() + vx * dt, y = particle.position.y() + vy * dt;
    if (x < 0 || x >= world.width) return {};
    if (y < 0 || y >= world.height) return {};
    if (particle.life <= particle.age + dt) return {};
    return Particle{{x, y}, {vx, vy}, particle.age + dt, particle.life};
}

} // namespace particles
