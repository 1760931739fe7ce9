// 11.8: after most_bounces bounces it loses its velocity as well
#include "particles.hpp"

#include <algorithm>

namespace particles {

namespace {
struct Hit {
    double time;    ///< from now [s]
    Vec2 normal;    ///< of the wall, to its left, of length 1
    double closing; ///< speed towards the wall [m/s]
};
} // namespace

/// The first wall that turns the particle within `time`.
static std::optional<Hit> next_wall(const Particle &particle, const std::vector<Wall> &walls, double time) {
    std::optional<Hit> first;
    for (const Wall &wall : walls) {
        const double length = (wall.end - wall.start).norm();
        const Vec2 along = (wall.end - wall.start) / length;
        const Vec2 normal{-along.y(), along.x()};

        const double closing = -particle.velocity.dot(normal);
        const double distance = (particle.position - wall.start).dot(normal);
        if (closing <= touching || distance < -touching) continue;

        const double t = std::max(0.0, distance / closing);
        if (t > time || (first && t >= first->time)) continue;
        const double s = (particle.position + t * particle.velocity - wall.start).dot(along);
        if (s >= -touching && s <= length + touching) first = Hit{t, normal, closing};
    }
    return first;
}

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
        const auto hit = next_wall(now, walls, dt);
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) return now;
        now.velocity += (1 + restitution) * hit->closing * hit->normal;
        dt -= hit->time;
    }
    now.velocity = {0, 0};
    return now;
}

} // namespace particles
