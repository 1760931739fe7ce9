// 11.8: each wall is turned onto the x axis; there only y is reversed
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
    double left = dt;
    for (int bounces = 0; bounces < max_bounces && left >= 0; ++bounces) {
        double least = 2 * left + 1; // later than the end
        Eigen::Matrix2d of_first;
        for (const auto &[start, end] : walls) {
            const Vec2 x = (end - start).normalized();
            Eigen::Matrix2d frame;
            frame << x.x(), x.y(), -x.y(), x.x();
            const Vec2 p = frame * (now.position - start), v = frame * now.velocity;
            if (v.y() >= -contact_tolerance || p.y() < -contact_tolerance) continue;
            const double t = std::max(p.y(), 0.0) / -v.y();
            const double at = p.x() + t * v.x();
            if (t < least && at > -contact_tolerance && at < (end - start).norm() + contact_tolerance) {
                least = t;
                of_first = frame;
            }
        }
        if (least > left) {
            now.position += left * now.velocity;
            break;
        }
        now.position += least * now.velocity;
        Vec2 v = of_first * now.velocity;
        v.y() *= -restitution;
        now.velocity = of_first.transpose() * v;
        left -= least;
    }
    return now;
}

} // namespace particles
