#pragma once
#include "../01_motion/motion.hpp"
#include "../course.hpp"
#include "../interface.hpp"

/// Section 3: how hard masses pull on each other, and how things fall: down, and around.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest term in its sum, unless its function says otherwise; with points
/// closer to each other than 1e-9 m, but not the same, or with other numbers that small, it may be right to fewer.
namespace gravity_wells {

using course::Vec2;
using motion::PointMass, motion::State;

//> Gravity
/// The force with which `other` pulls on `body` [N]. At the same point it is (0, 0): there is no direction to pull in.
/// @param G  the gravitational constant [N m²/kg²], not negative; a game may have its own
/// @throws std::invalid_argument if `G` or a mass is negative, or a number is not within ±1e5.
Vec2 gravity(const PointMass &body, const PointMass &other, double G);

//> Time to fall
/// How long something falls until it reaches the floor [s]: 0 if it is there already, unless it is thrown upwards.
/// Right to twelve digits; if it is thrown downwards, to as many decimal places as if it were thrown upwards.
/// @param height    above the floor at the start [m], not negative
/// @param velocity  at the start [m/s]: positive upwards
/// @param g         how much faster it falls each second [m/s²], more than 0
/// @throws std::invalid_argument if `height` is negative, `g` is not positive, or a number is not within ±1e5.
double time_to_fall(double height, double velocity, double g);

//> A fall
/// Something that falls straight down onto a floor.
struct Fall {
    double height{};   ///< above the floor [m], not negative
    double velocity{}; ///< [m/s]: positive upwards
    double time{};     ///< how long it has been in the air [s]
    COURSE_FIELDS("m, m/s, s", height, velocity, time)
};

//> Fall and land
/// The fall `dt` seconds later, or when it reaches the floor, if that is earlier.
/// There its height is 0, exactly, also if `dt` is just what `time_to_fall` says; its velocity and time are those of that
/// moment, both as exact as `time_to_fall`.
/// What is on the floor and does not move upwards stays as it is, and its time, too.
/// @param g   how much faster it falls each second [m/s²], more than 0
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `now.height` or `dt` is negative, `g` is not positive, or a number is not within ±1e5.
Fall fall_and_land(const Fall &now, double g, double dt);

//> Circular orbit
/// The speed at which a ship circles a body of this mass [m/s], which stays where it is: it is far heavier, or held.
/// @param mass    of the body in the middle [kg], not negative
/// @param radius  of the circle [m], more than 0
/// @param G       the gravitational constant [N m²/kg²], not negative
/// @throws std::invalid_argument if `mass` or `G` is negative, `radius` is not positive, or a number is not within ±1e5.
double circular_orbit_speed(double mass, double radius, double G);

//> One step of an orbit
/// A ship `dt` seconds later, by one step of semi-implicit Euler: it is pulled where it is, and moves at its new velocity.
/// In the middle of the well, nothing pulls on it.
/// @param mu  strength of the well, which is at (0, 0): its mass times G [m³/s²], not negative
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `mu` or `dt` is negative, or a number is not within ±1e5.
State orbit_step(const State &ship, double mu, double dt);

//> Softened gravity
/// The acceleration of a ship in a softened well at (0, 0) [m/s²]: at a distance r, mu r / (r² + epsilon²)^(3/2)
/// towards the well.
/// @param mu       strength of the well [m³/s²], not negative
/// @param epsilon  how far from the middle it is softened [m], more than 0
/// @throws std::invalid_argument if `mu` is negative, `epsilon` is not positive, or a number is not within ±1e5.
Vec2 softened_gravity(const Vec2 &position, double mu, double epsilon);

//> Four integrators
/// The same ship four times, each moved by an integrator of its own.
struct Integrators {
    State explicit_euler; ///< moves at its old velocity, and is pulled as at its old position
    State semi_implicit;  ///< as `orbit_step`
    State leapfrog;       ///< gets half of the pull at its old position, moves, and gets half of that at its new one
    State runge_kutta;    ///< the classical Runge–Kutta method of order 4
    COURSE_FIELDS("1, 1, 1, 1", explicit_euler, semi_implicit, leapfrog, runge_kutta)
};

//> One step of all four
/// All four one step later, each continued from its own state. In the middle of the well, nothing pulls.
/// @param mu  strength of the well, which is at (0, 0) [m³/s²], not negative
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `mu` or `dt` is negative, or a number is not within ±1e5.
Integrators step_all(const Integrators &before, double mu, double dt);

//> Kepler's ellipse
/// Where a ship is at time t [m], if its orbit is an ellipse around a well at (0, 0). At t = 0 it is nearest to the well,
/// on the right of it, at (semi_major (1 - eccentricity), 0), and flies upwards: anticlockwise.
/// Right to nine digits of `semi_major`, for eccentricities up to 0.99, and up to a hundred turns before or after t = 0;
/// beyond that it may be right to fewer.
/// @param semi_major    half of the ellipse's length [m], more than 0
/// @param eccentricity  from 0, a circle, to less than 1 [1]
/// @param mu            strength of the well [m³/s²], more than 0
/// @param t             [s]; a negative t asks where it was before
/// @throws std::invalid_argument if `semi_major` or `mu` is not positive, `eccentricity` is negative or not below 1, or a
///         number is not within ±1e5.
Vec2 kepler_position(double semi_major, double eccentricity, double mu, double t);

//> The exercises
namespace subject {
COURSE_EXERCISE("3.1", core, gravity_wells, gravity, "body, other, G [N m²/kg²]", "N")
COURSE_EXERCISE("3.2", core, gravity_wells, time_to_fall, "height [m], velocity [m/s], g [m/s²]", "s")
COURSE_EXERCISE("3.3", core, gravity_wells, fall_and_land, "now, g [m/s²], dt [s]", "")
COURSE_EXERCISE("3.4", core, gravity_wells, circular_orbit_speed, "mass [kg], radius [m], G [N m²/kg²]", "m/s")
COURSE_EXERCISE("3.5", stretch, gravity_wells, orbit_step, "ship, mu [m³/s²], dt [s]", "")
COURSE_EXERCISE("3.6", stretch, gravity_wells, softened_gravity, "position [m], mu [m³/s²], epsilon [m]", "m/s²")
COURSE_EXERCISE("3.7", challenge, gravity_wells, step_all, "before, mu [m³/s²], dt [s]", "")
COURSE_EXERCISE("3.8", challenge, gravity_wells, kepler_position, "semi_major [m], eccentricity [1], mu [m³/s²], t [s]",
                "m")
} // namespace subject
//>
} // namespace gravity_wells
