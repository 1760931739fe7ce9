#pragma once
// The game of this chapter, as it grows: two balls that meet, a break shot, a crowd, and a thousand balls.
#include "../06_reflection/reflection.hpp"
#include "nt_collisions.hpp"

#include <cmath>
#include <cstddef>

namespace nt_collisions {

//> The world
constexpr double frame_time = 1.0 / 60; ///< [s]
using reflection::Box;

//> The components as arrows
/// A velocity's normal and tangential component as two arrows, which add up to the velocity.
struct Arrows {
    Vec2 normal;     ///< [m/s]
    Vec2 tangential; ///< [m/s]
};
inline Arrows arrows(const Vec2 &velocity, const Vec2 &a, const Vec2 &b) {
    const Components parts = decompose(velocity, a, b);
    const Vec2 n = (b - a).normalized(), t{-n.y(), n.x()};
    return {parts.normal * n, parts.tangential * t};
}

//> Do they touch?
inline bool touch(const Ball &a, const Ball &b) {
    const double reach = a.radius + b.radius;
    return (b.position - a.position).squaredNorm() <= reach * reach;
}

//> The frame loop: two equal balls
/// One frame of the game: when two balls touch, they collide; then both roll for `dt` seconds.
inline void next_frame(Ball &a, Ball &b, double dt) {
    if (touch(a, b)) {
        const Velocities after = exchange(a, b);
        a.velocity = after.a;
        b.velocity = after.b;
    }
    a.position += dt * a.velocity;
    b.position += dt * b.velocity;
}

//> Two balls collide
inline void collide(Ball &a, Ball &b, double restitution) {
    const Velocities after = resolve_collision(a, b, restitution);
    a.velocity = after.a;
    b.velocity = after.b;
}

//> A rack
/// A cue ball, and 6 m to its right, at `tip`, the first of fifteen balls in a triangle, 2 mm apart.
inline std::vector<Ball> rack(const Vec2 &tip, const Vec2 &cue_velocity) {
    std::vector<Ball> balls{{tip - Vec2{6, 0}, cue_velocity, 0.3, 1}};
    for (int line = 0; line < 5; ++line)
        for (int k = 0; k <= line; ++k)
            balls.push_back({{tip.x() + 0.5215 * line, tip.y() + 0.602 * (k - 0.5 * line)}, {0, 0}, 0.3, 1});
    return balls;
}

//> Between the sides of a table
/// All balls roll for `dt` seconds; the sides of the table turn back what's past them, by section 6.
inline void roll(std::vector<Ball> &balls, const Box &table, double dt) {
    for (Ball &ball : balls) {
        ball.velocity = bounce_in_box({ball.position, ball.velocity, ball.radius}, table);
        ball.position += dt * ball.velocity;
    }
}

//> The frame loop: many balls
/// One frame of the game: any two balls that touch collide, and then all of them roll.
inline void next_frame(std::vector<Ball> &balls, const Box &table, double restitution, double dt) {
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = i + 1; k < balls.size(); ++k)
            if (touch(balls[i], balls[k])) collide(balls[i], balls[k], restitution);
    roll(balls, table, dt);
}

//> The frame loop: contact between frames
/// One frame of the game for two balls, which may meet at any moment during the frame.
inline void next_frame_with_contact(Ball &a, Ball &b, double restitution, double dt) {
    const std::optional<double> contact = time_of_impact(a, b);
    const double first = contact && *contact < dt ? *contact : dt; // until then nothing happens [s]
    a.position += first * a.velocity;
    b.position += first * b.velocity;
    if (first == dt) return;
    collide(a, b, restitution);
    a.position += (dt - first) * a.velocity; // what's left of the frame
    b.position += (dt - first) * b.velocity;
}

//> The frame loop: a crowd
/// One frame of the game: any two discs that overlap are pushed apart, once.
inline void next_frame(std::vector<Disc> &discs) {
    for (std::size_t i = 0; i < discs.size(); ++i)
        for (std::size_t k = i + 1; k < discs.size(); ++k) {
            const Positions apart = push_apart(discs[i], discs[k]);
            discs[i].position = apart.a;
            discs[k].position = apart.b;
        }
}

//> All centres
inline std::vector<Vec2> centres_of(const std::vector<Ball> &balls) {
    std::vector<Vec2> centres;
    for (const Ball &ball : balls) centres.push_back(ball.position);
    return centres;
}

//> The frame loop: a thousand balls
/// One frame of the game for balls of one size: only close pairs are checked.
inline void next_frame_with_pairs(std::vector<Ball> &balls, const Box &table, double restitution, double dt) {
    if (balls.empty()) return;
    for (const Pair &pair : close_pairs(centres_of(balls), 2 * balls[0].radius)) {
        Ball &a = balls[std::size_t(pair.first)], &b = balls[std::size_t(pair.second)];
        if (touch(a, b)) collide(a, b, restitution);
    }
    roll(balls, table, dt);
}
//>
} // namespace nt_collisions
