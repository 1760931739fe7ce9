// Section 3, Gravity wells. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 3
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "gravity_wells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gravity_wells {

// 3.1 core
Vec2 gravity(const PointMass &body, const PointMass &other, double G) {
    course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    course::require(other.mass >= 0, "mass [kg] must not be negative", other.mass);
    course::require(G >= 0, "G [N m²/kg²] must not be negative", G);
    throw course::NotYet{"how far is it from body to other, and in which direction? Then: how hard is the pull?"};
}

static void require_fall(double height, double g) {
    course::require(height >= 0, "height [m] must not be negative", height);
    course::require(g > 0, "g [m/s²] must be positive", g);
}

// 3.2 core
double time_to_fall(double height, double velocity, double g) {
    require_fall(height, g);
    throw course::NotYet{"how fast does it hit the floor, and how long does its velocity take to become that?"};
}

// 3.3 core
Fall fall_and_land(const Fall &now, double g, double dt) {
    require_fall(now.height, g);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    throw course::NotYet{"does it reach the floor within dt? If not, where is it then? If so, when?"};
}

// 3.4 core
double circular_orbit_speed(double mass, double radius, double G) {
    course::require(mass >= 0, "mass [kg] must not be negative", mass);
    course::require(radius > 0, "radius [m] must be positive", radius);
    course::require(G >= 0, "G [N m²/kg²] must not be negative", G);
    throw course::NotYet{"how strong is the acceleration there, and which speed on a circle goes with it?"};
}

static void require_step(double mu, double dt) {
    course::require(mu >= 0, "mu [m³/s²] must not be negative", mu);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

// 3.5 stretch
State orbit_step(const State &ship, double mu, double dt) {
    require_step(mu, dt);
    throw course::NotYet{"what pulls on the ship where it is now? At which velocity does it move, then?"};
}

// 3.6 stretch
Vec2 softened_gravity(const Vec2 &position, double mu, double epsilon) {
    course::require(mu >= 0, "mu [m³/s²] must not be negative", mu);
    course::require(epsilon > 0, "epsilon [m] must be positive", epsilon);
    throw course::NotYet{"make the distance larger, so that it is never 0, wherever you divide by it"};
}

// 3.7 challenge
Integrators step_all(const Integrators &before, double mu, double dt) {
    require_step(mu, dt);
    throw course::NotYet{"begin with the two that you know from section 1; then split the pull of one step in two"};
}

// 3.8 challenge
Vec2 kepler_position(double semi_major, double eccentricity, double mu, double t) {
    course::require(semi_major > 0, "semi_major [m] must be positive", semi_major);
    course::require(0 <= eccentricity && eccentricity < 1, "eccentricity must be from 0 to less than 1", eccentricity);
    course::require(mu > 0, "mu [m³/s²] must be positive", mu);
    throw course::NotYet{"on a circle the angle grows evenly; which angle does so on an ellipse?"};
}

static void require_lander(const Lander &now, const Controls &controls, double g, double dt) {
    require_fall(now.state.position.y(), g);
    course::require(now.fuel >= 0, "fuel [s] must not be negative", now.fuel);
    course::require(std::abs(controls.jets) <= 1, "jets must be -1, 0 or 1", controls.jets);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

// 3.9 challenge
Lander fly_lander(Lander now, const Controls &controls, double pad, double g, double dt) {
    require_lander(now, controls, g, dt);
    throw course::NotYet{"what happens first: does it touch, is the fuel used up, or is the frame over?"};
}

} // namespace gravity_wells
