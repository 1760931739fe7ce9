// 11.3: seven digits for the velocity
#include "particles.hpp"

namespace particles {

std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    course::require_range(world.gravity, world.wind, world.width, world.height, dt);
    course::require(world.width > 0, "width [m] must be positive", world.width);
    course::require(world.height > 0, "height [m] must be positive", world.height);
    course::require(dt >= 0, "dt [s] must not be negative", dt);

    Particle next = particle;
    next.velocity += Vec2{float(dt) * float(world.wind), -float(dt) * float(world.gravity)};
    next.position += dt * next.velocity;
    next.age += dt;

    const bool seen = next.position.x() >= 0 && next.position.x() < world.width && next.position.y() >= 0
                      && next.position.y() < world.height;
    if (!seen || next.age >= next.life) return {};
    return next;
}

} // namespace particles
