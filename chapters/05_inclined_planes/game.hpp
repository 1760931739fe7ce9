#pragma once
// The game of this chapter, as it grows: a puck on a table, and a box on a board.
#include "../01_motion/motion.hpp"
#include "inclined_planes.hpp"

#include <cmath>
#include <numbers>

namespace inclined_planes {

//> The world
constexpr double g = 10;                ///< how much faster a falling thing gets each second [m/s²]
constexpr double deceleration = 2;      ///< how much speed friction takes from the puck each second [m/s²]
constexpr double frame_time = 1.0 / 60; ///< [s]

//> Degrees and radians
constexpr double degree = std::numbers::pi / 180; ///< [rad]

//> The frame loop: a puck that slows down
/// One frame of the game: the puck moves on for `dt` seconds, and its velocity changes steadily.
inline void next_frame(motion::State &puck, double dt) {
    puck = motion::accelerated_motion(puck, {-deceleration, 0}, dt);
}

//> A puck
/// A puck that slides along a straight line.
struct Puck {
    double x{};        ///< [m]
    double velocity{}; ///< [m/s]
};

//> The frame loop: a puck that stops
/// One frame of the game: friction slows the puck down, and stops it.
inline void next_frame(Puck &puck, double dt) {
    const double before = puck.velocity;
    puck.velocity = apply_friction(before, deceleration, dt);
    puck.x += (before + puck.velocity) / 2 * dt; // at the average of both velocities
}

//> A box on a board
/// How far a box has slid down its board, and how fast it is.
struct Sliding {
    double way{};   ///< down the board [m]
    double speed{}; ///< down the board [m/s], negative: upwards
};

/// What friction takes of the speed of a box that slides, each second [m/s²].
inline double friction_of(const Box &box, double angle) {
    return box.mu_k * normal_force(box.mass, angle, g) / box.mass;
}

//> The frame loop: a box on a board
/// One frame of the game: the board holds the box, or the box slides down.
inline void next_frame(Sliding &it, const Box &box, double angle, double dt) {
    if (it.speed == 0 && incline_acceleration(box, angle, g) == 0) return; // static friction holds it
    const double before = it.speed;
    it.speed = apply_friction(before + g * std::sin(angle) * dt, friction_of(box, angle), dt);
    it.way += (before + it.speed) / 2 * dt;
}

//> The frame loop: a puck on a table
/// One frame of the game, seen from above: the puck slides straight on until it stops.
inline void next_frame(motion::State &puck, double loss, double dt) {
    const Vec2 before = puck.velocity;
    puck.velocity = table_friction(before, loss, dt);
    puck.position += (before + puck.velocity) / 2 * dt;
}

//> The frame loop: a box that is pushed up
/// One frame of the game: while the box goes up, the slope and friction both slow it down.
inline void next_frame_up(Sliding &it, const Box &box, double angle, double dt) {
    if (it.speed >= 0) return next_frame(it, box, angle, dt);
    const double before = it.speed;
    it.speed = apply_friction(before, g * std::sin(angle) + friction_of(box, angle), dt);
    it.way += (before + it.speed) / 2 * dt;
}

//> A block on a spring
constexpr Box block{2, 0.5, 0.3}; ///< static friction holds 10 N, kinetic friction is 6 N
constexpr Spring spring{20, 0.2}; ///< 10 N at a stretch of half a metre

/// One frame of the game: the block sticks, or slips.
inline void next_frame(Pulled &pulled, double dt) { pulled = stick_slip_step(pulled, block, spring, g, dt); }
//>
} // namespace inclined_planes
