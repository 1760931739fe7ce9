// 7.4: a wall reached in the very last instant reflects the ball in the next frame, not in this one
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    double area = 0;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &next = room[(i + 1) % room.size()];
        course::require(room[i] != next, "the length of a wall [m] must be positive", 0);
        area += det(room[i] - room[0], next - room[0]);
    }

    Ball now = ball;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        double time = dt;
        Vec2 turned = now.velocity;
        bool hit = false;
        for (std::size_t i = 0; i < room.size(); ++i) {
            const Vec2 wall = room[(i + 1) % room.size()] - room[i];
            const double length = wall.norm();
            const Vec2 along = wall / length, inward = (area < 0 ? -1 : 1) * Vec2{-along.y(), along.x()};
            const double closing = -now.velocity.dot(inward), distance = (now.position - room[i]).dot(inward);
            if (closing <= 0 || distance < -contact_tolerance) continue;
            const double t = std::max(0.0, distance / closing);
            const double s = (now.position + t * now.velocity - room[i]).dot(along);
            if (t >= time || s < -contact_tolerance || s > length + contact_tolerance) continue;
            time = t;
            turned = now.velocity + 2 * closing * inward;
            hit = true;
        }
        now.position += time * now.velocity;
        now.velocity = turned;
        dt -= time;
        if (!hit) break;
    }
    return now;
}

} // namespace segment_intersection
