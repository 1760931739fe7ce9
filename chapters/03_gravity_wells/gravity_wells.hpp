#pragma once
#include "../01_motion/motion.hpp"
#include "../course.hpp"
#include "../interface.hpp"

/// Section 3: how hard masses pull on each other, and how things fall: down, and around.
/// Numbers that go in are within ±1e5; an answer may be larger.
/// Twelve digits must be right, in 3.8 nine; where fewer will do, the tests say.
namespace gravity_wells {

using course::Vec2;
using motion::PointMass, motion::State;

//> Gravity
/// The force that pulls `body` towards `other` [N]. When both are at the same point, it's (0, 0): there's no direction to
/// pull in. Nearer to each other than 1e-140 m it may be infinite, or 0.
/// @param G  the gravitational constant [N m²/kg²], not negative; a game may have its own
/// @throws std::invalid_argument if `G` or a mass is negative.
Vec2 gravity(const PointMass &body, const PointMass &other, double G);

//> Time to fall
/// How long something falls until it's on the floor [s]: 0 when it's there already, unless it's thrown upwards.
/// @param height    above the floor at the start [m], not negative
/// @param velocity  at the start [m/s]: positive upwards
/// @param g         how much faster it falls each second [m/s²], more than 0
/// @throws std::invalid_argument if `height` is negative, or `g` is not positive.
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
/// The fall `dt` seconds later, or when it lands, if that's earlier. Then its height is exactly 0, even when `dt` is just
/// what `time_to_fall` returns, and its velocity and time are those of that moment. On the floor, and not on its way up,
/// it stays as it is, and so does its time.
/// @param g   how much faster it falls each second [m/s²], more than 0
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `now.height` or `dt` is negative, or `g` is not positive.
Fall fall_and_land(const Fall &now, double g, double dt);

//> Circular orbit
/// How fast a ship circles a body of this mass [m/s], which stays where it is because it's far heavier, or held.
/// @param mass    of the body in the middle [kg], not negative
/// @param radius  of the circle [m], more than 0
/// @param G       the gravitational constant [N m²/kg²], not negative
/// @throws std::invalid_argument if `mass` or `G` is negative, or `radius` is not positive.
double circular_orbit_speed(double mass, double radius, double G);

//> One step of an orbit
/// A ship `dt` seconds later, by one step of semi-implicit Euler: it's pulled where it is, then moves at its new velocity.
/// In the middle of the well, nothing pulls.
/// @param mu  how strong the well at (0, 0) is: its mass times G [m³/s²], not negative
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `mu` or `dt` is negative.
State orbit_step(const State &ship, double mu, double dt);

//> Softened gravity
/// The acceleration of a ship in a softened well at (0, 0) [m/s²]: at a distance r it's mu r / (r² + epsilon²)^(3/2),
/// towards the well.
/// @param mu       how strong the well is [m³/s²], not negative
/// @param epsilon  how far from the middle it's softened [m], more than 0
/// @throws std::invalid_argument if `mu` is negative, or `epsilon` is not positive.
Vec2 softened_gravity(const Vec2 &position, double mu, double epsilon);

//> Four integrators
/// The same ship four times, each moved by an integrator of its own.
struct Integrators {
    State explicit_euler; ///< moves at its old velocity, and is pulled as at its old position
    State semi_implicit;  ///< does what `orbit_step` does
    State leapfrog;       ///< gets half the pull at its old position, moves, and gets half the pull at its new one
    State runge_kutta;    ///< the classical Runge–Kutta method of order 4
    COURSE_FIELDS("1, 1, 1, 1", explicit_euler, semi_implicit, leapfrog, runge_kutta)
};

//> One step of all four
/// All four one step later, each from its own state. In the middle of the well, nothing pulls.
/// @param mu  how strong the well at (0, 0) is [m³/s²], not negative
/// @param dt  [s], not negative
/// @throws std::invalid_argument if `mu` or `dt` is negative.
Integrators step_all(const Integrators &before, double mu, double dt);

//> Kepler's ellipse
/// Where a ship on an ellipse around a well at (0, 0) is at time t [m]. At t = 0 it's nearest to the well, to the right of
/// it, at (semi_major (1 - eccentricity), 0), and flies upwards: anticlockwise.
/// @param semi_major    half of the ellipse's length [m], more than 0
/// @param eccentricity  from 0, a circle, to less than 1 [1]
/// @param mu            how strong the well is [m³/s²], more than 0
/// @param t             [s]; with a negative t, it's where the ship was before
/// @throws std::invalid_argument if `semi_major` or `mu` is not positive, or `eccentricity` is negative or not below 1.
Vec2 kepler_position(double semi_major, double eccentricity, double mu, double t);

//> A lander
constexpr double thrust = 4.5, jet = 1; ///< how much faster the engine and a jet make it each second [m/s²]
constexpr double half_pad = 3;          ///< half the width of the pad that it's to land on [m]
constexpr double soft = 2;              ///< the hardest touch that it survives [m/s]

struct Lander {
    State state;          ///< where its feet are, y above the ground, never below it [m], and their velocity [m/s]
    double fuel{};        ///< how long the engine can still burn [s], not negative
    bool landed = false;  ///< for good
    bool crashed = false; ///< for good
    COURSE_FIELDS(", s, , ", state, fuel, landed, crashed)
};

//> Controls
/// What the player holds down.
struct Controls {
    bool engine = false; ///< pushes up while there's fuel
    int jets = 0;        ///< -1: push to the left, 1: to the right; they need no fuel
    COURSE_FIELDS(", 1", engine, jets)
};

//> Fly a lander
/// The lander `dt` seconds later. The Moon, the engine and the jets accelerate it, each steadily. The engine stops at the
/// moment the fuel runs out, and the flight ends at the moment the lander touches the ground, at y = 0 and with the
/// velocity of that moment: from then on nothing changes. It has landed if its speed is at most `soft` and it's within
/// `half_pad` of the pad's middle; if not, it has crashed. If it starts on the ground, it touches at once, unless it rises
/// or the engine is about to lift it.
/// @param pad  x of the middle of the pad [m]
/// @param g    how much faster it falls each second [m/s²], more than 0
/// @param dt   [s], not negative
/// @throws std::invalid_argument if it's below the ground, `fuel` or `dt` is negative, `jets` isn't -1, 0 or 1, or `g`
///         isn't positive.
Lander fly_lander(Lander now, const Controls &controls, double pad, double g, double dt);

//>
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
COURSE_EXERCISE("3.9", challenge, gravity_wells, fly_lander, "now, controls, pad [m], g [m/s²], dt [s]", "")
} // namespace subject
} // namespace gravity_wells
