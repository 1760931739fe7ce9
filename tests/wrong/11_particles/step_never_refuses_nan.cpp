// 11.3: "not a number" is never outside by a comparison, and never old: it lives on, as in the source
#include "particles.hpp"

namespace particles {

std::optional<Particle> step(const Particle &particle, const World &world, double dt) {

    Particle next = particle;
    next.velocity += dt * Vec2{world.wind, -world.gravity};
    next.position += dt * next.velocity;
    next.age += dt;

    const Vec2 p = next.position;
    const bool seen = !(p.x() < 0 || p.x() >= world.width || p.y() < 0 || p.y() >= world.height);
    if (!seen || next.age >= next.life) return {};
    return next;
}

} // namespace particles
