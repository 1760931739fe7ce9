#pragma once
// The game of this chapter, as it grows: a cannon, on level ground and on a cliff.
#include "trajectories.hpp"

#include <algorithm>

namespace trajectories {

//> The world
constexpr double g = 10;                ///< how much faster a shell falls each second [m/s²]
constexpr double speed = 25;            ///< of a shell at the muzzle [m/s]
constexpr double cliff = 25;            ///< height of the cliff [m]
constexpr double frame_time = 1.0 / 60; ///< [s]

/// Where the shell leaves the cannon, and its velocity there. The muzzle is right above x = 0.
inline State fired(double height, double angle_deg) { return {{0, height}, launch_velocity(speed, angle_deg)}; }

//> The frame loop: a shell
/// One frame of the game: the shell flies on for `dt` seconds.
inline void next_frame(State &shell, double dt) { shell = motion::accelerated_motion(shell, {0, -g}, dt); }

//> A shell that knows when it lands
/// A shell that knows how long it'll be in the air.
struct Flight {
    State shell;
    double left = time_of_flight(shell, g); ///< until it lands [s]
};

//> The frame loop: a shell that lands
/// One frame of the game: the shell flies on, and when it lands in this frame, it stops at the ground.
inline void next_frame(Flight &flight, double dt) {
    dt = std::min(dt, flight.left);
    next_frame(flight.shell, dt);
    flight.left -= dt;
}

//> The frame loop: wind
/// One frame of the game in a steady wind, which pushes the shell sideways.
inline void next_frame(Flight &flight, double wind, double dt) {
    dt = std::min(dt, flight.left);
    flight.shell = motion::accelerated_motion(flight.shell, {wind, -g}, dt);
    flight.left -= dt;
}

//> Air
/// What a shell flies through.
struct Air {
    double drag = 0.025; ///< of our shell [1/m]
    Vec2 wind{0, 0};     ///< [m/s]
};

//> The frame loop: air
/// One frame of the game in air, which slows the shell down, and carries it along when there's wind.
inline void next_frame(State &shell, const Air &air, double dt) { shell = drag_step(shell, g, air.drag, air.wind, dt); }

/// Where a shell hits the ground that's below it after a frame, on a straight line from where it was before [m].
inline Vec2 hit(const Vec2 &before, const Vec2 &after) {
    const double fall = before.y() - after.y();
    return {before.x() + (fall > 0 ? before.y() / fall : 0) * (after.x() - before.x()), 0};
}
//>
} // namespace trajectories
