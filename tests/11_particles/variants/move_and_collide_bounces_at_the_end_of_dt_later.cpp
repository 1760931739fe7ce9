// 11.8: a wall reached at the very end of dt reflects it in the next call; of two hit at once, the later in the list acts first
#include "particles.hpp"

#include <algorithm>

namespace particles {

Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    if (restitution < 0 || restitution > 1 || dt < 0) throw std::invalid_argument{"no such restitution or time"};
    for (const Wall &wall : walls) {
        if ((wall.end - wall.start).norm() < 1e-3) throw std::invalid_argument{"no such wall"};
    }
    Particle now = particle;
    now.age += dt;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        double least = dt;
        std::optional<Vec2> normal;
        for (const auto &[start, end] : walls) {
            const Vec2 along = (end - start) / (end - start).norm(), left{-along.y(), along.x()};
            const double closing = -now.velocity.dot(left), distance = (now.position - start).dot(left);
            if (closing <= contact_tolerance || distance < -contact_tolerance) continue;
            const double t = std::max(0.0, distance / closing);
            const Vec2 there = now.position + t * now.velocity;
            const double beyond = std::max((start - there).dot(along), (there - end).dot(along));
            if (t < dt && t <= least && beyond <= contact_tolerance) {
                least = t;
                normal = left;
            }
        }
        now.position += least * now.velocity;
        if (!normal) break;
        now.velocity -= (1 + restitution) * now.velocity.dot(*normal) * *normal;
        dt -= least;
    }
    return now;
}

} // namespace particles
