#pragma once
// The game of this chapter, as it grows: a ball on a screen, off a wall that you turn, and on a pool table.
#include "reflection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflection {

//> The world
constexpr double frame_time = 1.0 / 60; ///< [s]
const Box screen{{0, 0}, {16, 9}};

//> Degrees and radians
constexpr double degree = std::numbers::pi / 180; ///< [rad]

/// A vector of length 1 that points there.
inline Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

//> The frame loop: a ball on a screen
/// One frame of the game: the sides of the screen turn the ball back, and it moves on for `dt` seconds.
inline void next_frame(Ball &ball, const Box &box, double dt) {
    ball.velocity = bounce_in_box(ball, box);
    ball.position += dt * ball.velocity;
}

//> The frame loop: a ball and a slanted wall
/// One frame of the game: a ball in front of a wall that goes through `point` and has no ends.
/// The normal has length 1, and points to the side where the ball may be.
inline void next_frame(Ball &ball, const Vec2 &point, const Vec2 &normal, double dt) {
    const double distance = (ball.position - point).dot(normal); // of its centre from the wall [m]
    const bool approaches = ball.velocity.dot(normal) < 0;
    if (distance < ball.radius && approaches) ball.velocity = reflect(ball.velocity, normal);
    ball.position += dt * ball.velocity;
}

//> The frame loop: a wall with two ends
/// A wall from one point to another; the ball is on its left.
struct Wall {
    Vec2 start; ///< [m]
    Vec2 end;   ///< [m]
};
inline void next_frame(Ball &ball, const Wall &wall, double dt) {
    next_frame(ball, wall.start, unit_normal(wall.start, wall.end), dt);
}

//> The frame loop: a rough wall
/// One frame of the game: a ball that touches the wall goes to 6.4, which checks whether it's coming closer.
inline void next_frame(Ball &ball, const Vec2 &point, const Vec2 &normal, const Surface &surface, double dt) {
    if ((ball.position - point).dot(normal) < ball.radius) ball.velocity = bounce(ball.velocity, normal, surface);
    ball.position += dt * ball.velocity;
}

//> The frame loop: a ball in a turned box
/// One frame of the game: the sides of the turned box turn the ball back.
inline void next_frame(Ball &ball, const Box &box, double angle, double dt) {
    ball.velocity = bounce_in_rotated_box(ball, box, angle);
    ball.position += dt * ball.velocity;
}

//> Folded
/// Where on the table a ball is when it's at x in the unfolded tables; low and high are its mirrors.
inline double folded(double x, double low, double high) {
    const double twice = 2 * (high - low); // after two tables everything looks the same again
    const double way = x - low - twice * std::floor((x - low) / twice);
    return low + std::min(way, twice - way); // on the second of the two the ball is coming back
}

//> The frame loop: a pool table
/// Where a ball's centre is after you pushed it in a direction of length 1 and it rolled `way` [m].
inline Vec2 rolled(const Ball &ball, const Box &table, const Vec2 &direction, double way) {
    const Vec2 unfolded = ball.position + way * direction, edge{ball.radius, ball.radius};
    const Vec2 low = table.low + edge, high = table.high - edge;
    return {folded(unfolded.x(), low.x(), high.x()), folded(unfolded.y(), low.y(), high.y())};
}

//> The frame loop: pinball
/// Turns a flipper towards an angle, at 9 rad/s.
inline void flip(Bumper &flipper, double wanted, double dt) {
    const Vec2 arm = flipper.end - flipper.start;
    const double angle = std::atan2(arm.y(), arm.x());
    flipper.turning = std::clamp(std::remainder(wanted - angle, 360 * degree) / dt, -9.0, 9.0);
    flipper.end = flipper.start + arm.norm() * at_angle(angle + flipper.turning * dt);
}
/// One frame of the game, in four steps, so that no ball gets through a wall. Its first two bumpers are the flippers.
inline void next_frame(Pinball &game, bool left, bool right, double dt) {
    for (int i = 0; i < 4; ++i) {
        flip(game.bumpers[0], (left ? 30 : -30) * degree, dt / 4);
        flip(game.bumpers[1], (right ? 150 : 210) * degree, dt / 4);
        game = play_pinball(game, {0, -6}, dt / 4);
    }
}
//>
} // namespace reflection
