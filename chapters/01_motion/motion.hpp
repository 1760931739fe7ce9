#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 1: where things are, how they move, and where their middle is.
/// A number that goes in must lie within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest term in its sum, unless its function says otherwise.
namespace motion {

using course::Vec2;

//> Pixels a second
/// How fast something runs over the screen [px/s].
/// @param px_per_frame       from each frame to the next [px/frame]; negative: to the left
/// @param frames_per_second  [frame/s], positive
/// @throws std::invalid_argument if `frames_per_second` is not positive, or a number is not within ±1e5.
double px_per_second(double px_per_frame, double frames_per_second);

//> Uniform motion
/// Where something is that moves at a constant velocity [m].
/// @param start     where it is at t = 0 [m]
/// @param velocity  [m/s]
/// @param t         [s]; negative: before it was at `start`
/// @throws std::invalid_argument if a number is not within ±1e5.
Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t);

//> Accelerated motion
/// Where something is, and how it moves.
struct State {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    COURSE_FIELDS("m, m/s", position, velocity)
};

/// The state of something that moves with a constant acceleration.
/// @param start         its state at t = 0
/// @param acceleration  [m/s²]
/// @param t             [s]; negative: before
/// @throws std::invalid_argument if a number is not within ±1e5.
State accelerated_motion(const State &start, const Vec2 &acceleration, double t);

//> Centre of mass
/// A body so small that only its place and its mass count.
struct PointMass {
    Vec2 position; ///< [m]
    double mass{}; ///< [kg], not negative
    COURSE_FIELDS("m, kg", position, mass)
};

/// The point on which all of them together would balance [m].
/// Nothing if there is no mass at all: if the list is empty, or every mass is 0. Less than 1e-100 kg may count as none.
/// @throws std::invalid_argument if a mass is negative, or a number is not within ±1e5.
std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies);

//> Three steps
/// The same motion three times, each stepped by a scheme of its own.
struct Schemes {
    State explicit_euler; ///< moves with the velocity that it has at the beginning of a step
    State semi_implicit;  ///< moves with the velocity that it has at the end of it
    State exact;          ///< moves as constant acceleration moves it
    COURSE_FIELDS("1, 1, 1", explicit_euler, semi_implicit, exact)
};

/// The three states one step later, each from its own state before. A step of 0 changes nothing.
/// @param acceleration  [m/s²]
/// @param dt            length of the step [s], not negative
/// @throws std::invalid_argument if `dt` is negative, or a number is not within ±1e5.
Schemes step(const Schemes &before, const Vec2 &acceleration, double dt);

//> The middle of a plate
/// The centre of mass of a flat plate, everywhere equally thick [m]: the centroid of a polygon.
/// For a square with sides between a centimetre and ten metres it is right to 1e-9 m, far from the origin too.
/// @param corners  in order, either way round [m]; they may repeat; that no sides cross is not checked
/// @throws std::invalid_argument if there are fewer than three corners, if they lie on one line, or if a number is not
///         within ±1e5. They lie on one line if the area is at most 1e-13 of the square of the longest distance between
///         two corners, and do not if it is 1e-11 of that or more. In between, either answer is right, as it is for a
///         plate shorter than 1e-100 m; and the thinner the plate, the fewer digits are right.
Vec2 centroid(const std::vector<Vec2> &corners);

//> Three looks at a motion
/// Where something was, once.
struct Sample {
    double t{}; ///< when [s]
    double x{}; ///< where [m]
    COURSE_FIELDS("s, m", t, x)
};

/// A motion along x with constant acceleration: x = x_0 + v_0 t + a t²/2.
struct Law {
    double x_0{}; ///< place at t = 0 [m]
    double v_0{}; ///< velocity at t = 0 [m/s]
    double a{};   ///< acceleration [m/s²]
    COURSE_FIELDS("m, m/s, m/s²", x_0, v_0, a)
};

/// The one such motion that was at these three places at these three times, which come in any order.
/// It is right to 1e-8, of itself if it is larger than 1, for places within ±1000 m and times within ±10 s that are half
/// a second or more apart. Closer together, or further from t = 0, fewer digits are right.
/// @throws std::invalid_argument if two of the times are equal, or a number is not within ±1e5.
Law law_of_motion(const Sample &first, const Sample &second, const Sample &third);

//> The exercises
namespace subject {
COURSE_EXERCISE("1.1", core, motion, px_per_second, "px_per_frame [px/frame], frames_per_second [frame/s]", "px/s")
COURSE_EXERCISE("1.2", core, motion, uniform_motion, "start [m], velocity [m/s], t [s]", "m")
COURSE_EXERCISE("1.3", core, motion, accelerated_motion, "start, acceleration [m/s²], t [s]", "")
COURSE_EXERCISE("1.4", core, motion, centre_of_mass, "bodies", "m")
COURSE_EXERCISE("1.5", stretch, motion, step, "before, acceleration [m/s²], dt [s]", "")
COURSE_EXERCISE("1.6", stretch, motion, centroid, "corners [m]", "m")
COURSE_EXERCISE("1.7", challenge, motion, law_of_motion, "first, second, third", "")
} // namespace subject
//>
} // namespace motion
