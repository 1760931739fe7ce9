// 7.4: t and s by determinants, t as a fraction of the motion, not in seconds; calls itself for the rest
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

/// `room` runs anticlockwise.
static Ball fly(const Ball &ball, const std::vector<Vec2> &room, double dt, int bounces_left) {
    if (bounces_left == 0) return ball;
    const Vec2 way = dt * ball.velocity;
    double first = 2;
    Vec2 hit_wall;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &from = room[i], &to = room[(i + 1) % room.size()];
        const Vec2 wall = to - from;
        const double d = det(ball.velocity, wall), slack = contact_tolerance / wall.norm();
        if (d <= 0 || det(wall, ball.position - from) < -contact_tolerance * wall.norm())
            continue; // inside is on the left
        const double t = std::max(0.0, det(from - ball.position, wall) / (dt * d));
        const double s =
            (t <= 1 ? det(ball.position + t * way - from, Vec2{wall.y(), -wall.x()}) / -wall.squaredNorm() : -1);
        if (t <= 1 && t < first && s >= -slack && s <= 1 + slack) {
            first = t;
            hit_wall = wall;
        }
    }
    if (first > 1) return {ball.position + way, ball.velocity};
    const Vec2 turned = 2 * hit_wall.dot(ball.velocity) / hit_wall.squaredNorm() * hit_wall - ball.velocity;
    return fly({ball.position + first * way, turned}, room, (1 - first) * dt, bounces_left - 1);
}

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    double area = 0;
    for (std::size_t i = room.size() - 1, next = 0; next < room.size(); i = next++) {
        course::require(room[i] != room[next], "the length of a wall [m] must be positive", 0);
        area += det(room[i] - room[0], room[next] - room[0]);
    }
    if (dt == 0) return ball; // no time: whether a wall has already acted is left open
    return fly(ball, area > 0 ? room : std::vector<Vec2>{room.rbegin(), room.rend()}, dt, max_bounces);
}

} // namespace segment_intersection
