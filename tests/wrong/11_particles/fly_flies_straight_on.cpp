// 11.8: no walls at all
#include "particles.hpp"

namespace particles {

namespace {
struct Hit {
    double time;    ///< from now [s]
    Vec2 normal;    ///< of the wall, to its left, of length 1
    double closing; ///< speed towards the wall [m/s]
};
} // namespace

Particle fly(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    course::require_range(restitution, dt);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const auto &[start, end] : walls) {
        course::require_range(start, end);
        course::require((end - start).norm() >= 1e-3, "a wall's length [m] must be 1e-3 or more", (end - start).norm());
    }

    Particle now = particle;
    now.age += dt;
    for (int bounces = 0; bounces < most_bounces; ++bounces) {
        const std::optional<Hit> hit;
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) break;
        now.velocity += (1 + restitution) * hit->closing * hit->normal;
        dt -= hit->time;
    }
    return now;
}

} // namespace particles
