// 11.8: t and s by determinants, and it calls itself for the time that is left
#include "particles.hpp"

namespace particles {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

static Particle go(Particle now, const std::vector<Wall> &walls, double restitution, double dt, int bounces) {
    if (bounces == max_bounces) return now;
    const Wall *first = nullptr;
    double least = dt;
    for (const Wall &wall : walls) {
        const Vec2 along = wall.end - wall.start, gap = now.position - wall.start;
        const double closing = -det(along, now.velocity), height = det(along, gap); // times the length
        const double length = along.norm();
        if (closing <= contact_tolerance * length || height < -contact_tolerance * length) continue;
        const double t = height > 0 ? height / closing : 0;
        const double s = (gap + t * now.velocity).dot(along) / (length * length);
        if (s < -contact_tolerance / length || s > 1 + contact_tolerance / length) continue;
        if (first ? t < least : t <= least) {
            least = t;
            first = &wall;
        }
    }
    now.position += least * now.velocity;
    if (!first) return now;
    const Vec2 along = (first->end - first->start).normalized();
    const double kept = now.velocity.dot(along), into = det(along, now.velocity);
    now.velocity = kept * along - restitution * into * Vec2{-along.y(), along.x()};
    return go(now, walls, restitution, dt - least, bounces + 1);
}

Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    if (restitution < 0 || restitution > 1 || dt < 0) throw std::invalid_argument{"no such restitution or time"};
    for (const Wall &wall : walls) {
        if ((wall.end - wall.start).norm() < 1e-3) throw std::invalid_argument{"no such wall"};
    }
    Particle after = go(particle, walls, restitution, dt, 0);
    after.age = particle.age + dt;
    return after;
}

} // namespace particles
