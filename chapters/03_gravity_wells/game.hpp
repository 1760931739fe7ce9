#pragma once
// The game of this chapter, as it grows: a ship near a black hole, and a lander on the Moon.
#include "gravity_wells.hpp"

namespace gravity_wells {

//> A ship and a hole
constexpr double G = 1;                 ///< this game's own gravitational constant [N m²/kg²]
const PointMass hole{{0, 0}, 800};      ///< a black hole of 800 kg
const double mu = G * hole.mass;        ///< how strong the hole is [m³/s²]
const State at_rest{{8, 0}, {0, 0}};    ///< 8 m to the right of the hole
constexpr double frame_time = 1.0 / 60; ///< [s]

/// A ship with an engine.
struct Ship {
    State state = at_rest;
    double mass = 2;   ///< [kg]
    Vec2 thrust{0, 0}; ///< force of the engine [N]
};

//> The frame loop: a ship
/// One frame of the game: the hole and the engine accelerate the ship for `dt` seconds.
inline void next_frame(Ship &ship, double dt) {
    const Vec2 pull = gravity({ship.state.position, ship.mass}, hole, G);
    ship.state.velocity += dt * (pull + ship.thrust) / ship.mass;
    ship.state.position += dt * ship.state.velocity;
}

//> The frame loop: a lander
constexpr double moon_g = 1.6; ///< how much faster things fall each second on the Moon [m/s²]

/// One frame of the game: the engine adds `burn` to the lander's velocity [m/s], and it falls for `dt` seconds.
inline void next_frame(Fall &lander, double burn, double dt) {
    lander.velocity += burn;
    lander = fall_and_land(lander, moon_g, dt);
}

//> The frame loop: a flight
/// One frame of the game, with what the player holds down; `pad` is the middle of where it's to land [m].
inline void next_frame(Lander &lander, const Controls &controls, double pad, double dt) {
    lander = fly_lander(lander, controls, pad, moon_g, dt);
}

//> The frame loop: an orbit
/// One frame of the game without an engine: by the integrator of 3.5.
inline void next_frame(State &ship, double dt) { ship = orbit_step(ship, mu, dt); }

//> Energy in a well
/// Kinetic and potential energy of each kilogram of a ship [J].
inline double energy_of(const State &ship) { return ship.velocity.squaredNorm() / 2 - mu / ship.position.norm(); }
//>
} // namespace gravity_wells
