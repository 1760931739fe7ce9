// 11.3: the position as x + v dt + a dt², which is what the scheme comes to
#include "particles.hpp"

namespace particles {

std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    if (world.width <= 0 || world.height <= 0 || dt < 0) throw std::invalid_argument{"no such world or time"};
    const Vec2 a{world.wind, -world.gravity};
    Particle next = particle;
    next.age = particle.age + dt;
    if (next.age >= particle.life) return {};
    next.position = particle.position + particle.velocity * dt + a * (dt * dt);
    next.velocity = particle.velocity + a * dt;
    const Vec2 size{world.width, world.height};
    if ((next.position.array() < 0).any() || (next.position.array() >= size.array()).any()) return {};
    return next;
}

} // namespace particles
