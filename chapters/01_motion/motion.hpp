#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 1: where things are, how they move, and where they balance.
/// Each number that goes in is within ±1e5, both ends included: the caller sees to that. An answer may be larger.
/// Twelve digits must be right; where fewer will do, the tests say.
namespace motion {

using course::Vec2;

//> Pixels per second
/// How fast something moves across the screen [px/s].
/// @param px_per_frame       how far it moves from one frame to the next [px/frame]; negative: to the left
/// @param frames_per_second  [frame/s], more than 0
/// @throws std::invalid_argument if `frames_per_second` is not positive.
double px_per_second(double px_per_frame, double frames_per_second);

//> Uniform motion
/// Where something is at time t, when its velocity stays the same [m].
/// @param start     its position at t = 0 [m]
/// @param velocity  [m/s]
/// @param t         [s]; negative: where it was before it came to `start`
Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t);

//> Accelerated motion
/// Where something is, and how it moves.
struct State {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    COURSE_FIELDS("m, m/s", position, velocity)
};

/// The state at time t, when the acceleration stays the same.
/// @param start         its state at t = 0
/// @param acceleration  [m/s²]
/// @param t             [s]; negative: the state before `start`
State accelerated_motion(const State &start, const Vec2 &acceleration, double t);

//> Centre of mass
/// A body so small that only its position and its mass matter.
struct PointMass {
    Vec2 position; ///< [m]
    double mass{}; ///< [kg], not negative
    COURSE_FIELDS("m, kg", position, mass)
};

/// The point where all these bodies together balance [m].
/// Nothing if there's no mass: the list is empty, or every mass is 0.
/// @throws std::invalid_argument if a mass is negative.
std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies);

//> Three integrators
/// One motion, three times, each by its own integrator.
struct Integrators {
    State explicit_euler; ///< moves at the velocity from the start of the step
    State semi_implicit;  ///< moves at the velocity from the end of the step
    State exact;          ///< ends the step where constant acceleration takes it
    COURSE_FIELDS("1, 1, 1", explicit_euler, semi_implicit, exact)
};

//> One step of each
/// All three one step later, each from its own state. A step of 0 s changes nothing.
/// @param acceleration  [m/s²]
/// @param dt            length of the step [s], not negative
/// @throws std::invalid_argument if `dt` is negative.
Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt);

//> The centroid of a plate
/// The centroid of a polygon [m]: where a plate balances that's equally thick everywhere. A plate
/// of 1 cm to 10 m is right to 1e-9 m, even 100 km from the origin.
/// @param corners  in order, either way round [m]; they may repeat. Sides mustn't cross, but that isn't checked
/// @throws std::invalid_argument if there are fewer than three corners, or if the corners
///         lie on one line: if the area is some 1e-12 of the square of the longest distance between two of them, or less.
Vec2 centroid(const std::vector<Vec2> &corners);

//> A sample and a motion
/// Where something was at one time.
struct Sample {
    double t{}; ///< [s]
    double x{}; ///< [m]
    COURSE_FIELDS("s, m", t, x)
};

/// A motion along x with constant acceleration: x = x_0 + v_0 t + a t²/2.
struct Motion {
    double x_0{}; ///< position at t = 0 [m]
    double v_0{}; ///< velocity at t = 0 [m/s]
    double a{};   ///< acceleration [m/s²]
    COURSE_FIELDS("m, m/s, m/s²", x_0, v_0, a)
};

//> A motion through three samples
/// The motion through these three samples, in any order.
/// @throws std::invalid_argument if two of the times are equal.
Motion fit_motion(const Sample &first, const Sample &second, const Sample &third);

//> A screen
/// A screen, and which part of the world is on it. Pixels are counted from its upper left corner: x to the right, y *down*.
struct Screen {
    Vec2 size;         ///< how wide it is, and how high [px]
    Vec2 centre;       ///< the place in the world that's in the middle of the screen [m]
    double px_per_m{}; ///< how many pixels long a metre is, more than 0
    COURSE_FIELDS("px, m, px/m", size, centre, px_per_m)
};

//> On the screen
/// Where a place is on the screen [px], or beyond its edges. In the world, y runs up.
/// @param place  in the world [m]
/// @throws std::invalid_argument if `px_per_m` is not positive.
Vec2 to_screen(const Vec2 &place, const Screen &screen);

//>
namespace subject {
COURSE_EXERCISE("1.1", core, motion, px_per_second, "px_per_frame [px/frame], frames_per_second [frame/s]", "px/s")
COURSE_EXERCISE("1.2", core, motion, uniform_motion, "start [m], velocity [m/s], t [s]", "m")
COURSE_EXERCISE("1.3", core, motion, accelerated_motion, "start, acceleration [m/s²], t [s]", "")
COURSE_EXERCISE("1.4", core, motion, centre_of_mass, "bodies", "m")
COURSE_EXERCISE("1.5", stretch, motion, step_all, "before, acceleration [m/s²], dt [s]", "")
COURSE_EXERCISE("1.6", challenge, motion, centroid, "corners [m]", "m")
COURSE_EXERCISE("1.7", stretch, motion, fit_motion, "first, second, third", "")
COURSE_EXERCISE("1.8", stretch, motion, to_screen, "place [m], screen", "px")
} // namespace subject
//>
} // namespace motion
