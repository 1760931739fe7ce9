// 7.4: directions as angles, which a wall mirrors; the angles by which the walls turn give the winding
#include "segment_intersection.hpp"

#include <cmath>

namespace segment_intersection {

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "corners", double(room.size()));
    for (std::size_t i = 0; i < room.size(); ++i)
        course::require(room[i] != room[(i + 1) % room.size()], "a wall needs length", 0);

    const double pi = std::acos(-1.0);
    double turned = 0;
    const int n = int(room.size());
    for (int i = 0; i < n; ++i) {
        const Vec2 u = room[(i + 1) % n] - room[i], v = room[(i + 2) % n] - room[(i + 1) % n];
        double angle = std::atan2(v.y(), v.x()) - std::atan2(u.y(), u.x());
        while (angle > pi) angle -= 2 * pi;
        while (angle < -pi) angle += 2 * pi;
        turned += angle;
    }
    double x = ball.position.x(), y = ball.position.y();
    double vx = ball.velocity.x(), vy = ball.velocity.y();
    double left = dt;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        double soonest = left;
        int which = -1;
        for (int i = 0; i < n; ++i) {
            const Vec2 p = room[i], q = room[(i + 1) % n];
            const double length = std::hypot(q.x() - p.x(), q.y() - p.y());
            double nx = -(q.y() - p.y()) / length, ny = (q.x() - p.x()) / length;
            if (turned < 0) nx = -nx, ny = -ny;
            const double towards = -(vx * nx + vy * ny);
            const double height = (x - p.x()) * nx + (y - p.y()) * ny;
            if (towards <= 0 || height < -contact_tolerance) continue;
            double t = height / towards;
            if (t < 0) t = 0;
            if (t > soonest) continue;
            if (which >= 0 && t == soonest) continue;
            const double hx = x + t * vx - p.x(), hy = y + t * vy - p.y();
            const double s = hx * (q.x() - p.x()) / length + hy * (q.y() - p.y()) / length;
            if (s < -contact_tolerance || s > length + contact_tolerance) continue;
            soonest = t;
            which = i;
        }
        x += soonest * vx;
        y += soonest * vy;
        if (which < 0) break;
        left -= soonest;
        const Vec2 w = room[(which + 1) % n] - room[which];
        const double wall = std::atan2(w.y(), w.x());
        const double speed = std::sqrt(vx * vx + vy * vy);
        const double out = 2 * wall - std::atan2(vy, vx);
        vx = speed * std::cos(out);
        vy = speed * std::sin(out);
    }
    return {Vec2{x, y}, Vec2{vx, vy}};
}

} // namespace segment_intersection
