// 7.4: the path stays straight; at each wall the room is mirrored, and at the end all of it is folded back
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

using Frame = Eigen::Isometry2d; ///< from the mirrored room back to the given one

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    double area = 0;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &a = room[i], &b = room[(i + 1) % room.size()];
        course::require(!(b - a).isZero(0), "the length of a wall [m] must be positive", 0);
        area += (a.x() - room[0].x()) * (b.y() - room[0].y()) - (a.y() - room[0].y()) * (b.x() - room[0].x());
    }

    Frame back = Frame::Identity();
    double now = 0;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        const Vec2 here = back * Vec2{ball.position + now * ball.velocity}, speed = back.linear() * ball.velocity;
        double soonest = dt - now;
        std::optional<Eigen::Hyperplane<double, 2>> mirror;
        for (std::size_t i = 0; i < room.size(); ++i) {
            const Vec2 wall = room[(i + 1) % room.size()] - room[i], along = wall.normalized();
            const Vec2 normal = area < 0 ? Vec2{along.y(), -along.x()} : Vec2{-along.y(), along.x()};
            const Eigen::Hyperplane<double, 2> plane{normal, room[i]};
            const double height = plane.signedDistance(here), closing = -normal.dot(speed);
            if (height < -contact_tolerance || closing <= 1e-13 * speed.norm()) continue; // it flies along
            const double wait = std::max(height, 0.0) / closing, place = along.dot(here + wait * speed - room[i]);
            if (place < -contact_tolerance || place > wall.norm() + contact_tolerance || wait > soonest) continue;
            soonest = wait;
            mirror = plane;
        }
        now += soonest;
        if (!mirror) break;
        const Vec2 n = mirror->normal();
        Frame fold = Frame::Identity();
        fold.linear() -= 2 * n * n.transpose();
        fold.translation() = -2 * mirror->offset() * n;
        back = fold * back;
    }
    return {back * Vec2{ball.position + now * ball.velocity}, back.linear() * ball.velocity};
}

} // namespace segment_intersection
