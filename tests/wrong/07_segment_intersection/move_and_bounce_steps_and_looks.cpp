// 7.4: a thousand little steps, and a turn where one ended outside: near, but not there
#include "segment_intersection.hpp"

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require_range(room);
    course::require_range(ball.position, ball.velocity, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    double area = 0;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &next = room[(i + 1) % room.size()];
        course::require(room[i] != next, "the length of a wall [m] must be positive", 0);
        area += det(room[i] - room[0], next - room[0]);
    }

    Ball now = ball;
    for (int step = 0; step < 1000; ++step) {
        now.position += dt / 1000 * now.velocity;
        for (std::size_t i = 0; i < room.size(); ++i) {
            const Vec2 wall = room[(i + 1) % room.size()] - room[i], along = wall.normalized();
            const Vec2 inward = (area < 0 ? -1 : 1) * Vec2{-along.y(), along.x()}, from = now.position - room[i];
            const double closing = -now.velocity.dot(inward), s = from.dot(along);
            if (closing > 0 && from.dot(inward) < 0 && s > 0 && s < wall.norm()) now.velocity += 2 * closing * inward;
        }
    }
    return now;
}

} // namespace segment_intersection
