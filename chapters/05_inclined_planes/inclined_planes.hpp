#pragma once
#include "../course.hpp"
#include "../interface.hpp"

/// Section 5: friction, on level ground and on a slope: what stops, what holds, and what slides.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest term in its sum, unless its function says otherwise; with numbers
/// closer to 0 than 1e-9, other than 0 itself, it may be right to fewer.
namespace inclined_planes {

using course::Vec2;

//> Stopping distance
/// How far a puck slides until it rests [m]: positive to the right, negative to the left.
/// @param velocity      [m/s], positive to the right
/// @param deceleration  how much of its speed friction takes each second [m/s²], more than 0
/// @throws std::invalid_argument if `deceleration` is not positive, or a number is not within ±1e5.
double stopping_distance(double velocity, double deceleration);

//> One frame of friction
/// The velocity of a puck one frame later [m/s]. Friction takes `deceleration` times `dt` from its speed, but never more
/// than there is: a puck that has stopped has the velocity 0, exactly, and a puck that rests stays at rest.
/// @param velocity      [m/s], positive to the right
/// @param deceleration  how much of its speed friction takes each second [m/s²], not negative
/// @param dt            length of the frame [s], not negative
/// @throws std::invalid_argument if `deceleration` or `dt` is negative, or a number is not within ±1e5.
double apply_friction(double velocity, double deceleration, double dt);

//> Normal force
/// How hard a box and the board on which it lies press against each other [N].
/// @param mass   [kg], more than 0
/// @param angle  of the board [rad]: 0 is level, π/2 upright
/// @param g      how much faster something falls each second [m/s²], more than 0
/// @throws std::invalid_argument if `mass` or `g` is not positive, `angle` is not from 0 to π/2, or a number is not
///         within ±1e5.
double normal_force(double mass, double angle, double g);

//> A box
/// A box, and how rough it is on its board.
struct Box {
    double mass{}; ///< [kg], more than 0
    double mu_s{}; ///< coefficient of static friction, while it rests [1], not less than mu_k
    double mu_k{}; ///< coefficient of kinetic friction, while it slides [1], not negative
    COURSE_FIELDS("kg, 1, 1", mass, mu_s, mu_k)
};

//> Acceleration on an incline
/// The acceleration down the board of a box that was put down on it at rest [m/s²]: 0 if friction holds it.
/// Where the pull is just as large as static friction can be, friction holds it; up to rounding, since nearer to that angle
/// than 1e-9 either is right.
/// @param angle  of the board [rad]: 0 is level, π/2 upright
/// @throws std::invalid_argument if `box` is not as `Box` says, or for what `normal_force` refuses.
double incline_acceleration(const Box &box, double angle, double g);

//> Critical angle
/// The steepest angle at which a board holds a box that rests on it [rad].
/// For a mu_s below 0.01 or above 100 it is right to 1e-9 rad.
/// @param mu_s  coefficient of static friction [1], not negative
/// @throws std::invalid_argument if `mu_s` is negative or not within ±1e5.
double critical_angle(double mu_s);

//> Friction on a table
/// The velocity of a puck on a table one frame later [m/s]. Friction takes `deceleration` times `dt` from its speed, but
/// never more than there is, and does not turn it. A speed beyond 1e5 may be refused, as `apply_friction` refuses it.
/// @param velocity  seen from above: positive to the right, and away from us
/// @throws std::invalid_argument for what `apply_friction` refuses.
Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt);

//> Up and back
/// What becomes of a box that is pushed up a board.
struct UpAndBack {
    double up{};   ///< how far it slides up the board [m]
    double back{}; ///< its speed when it is back where it began [m/s]; 0 if it stays up there
    COURSE_FIELDS("m, m/s", up, back)
};

//> Up a board, and back or not
/// How far a box slides up a board, and how fast it comes back.
/// Whether it stays up there is decided as in `incline_acceleration`. Near the critical angle `back` is right to fewer
/// digits: its square is right to twelve digits of the square of `speed`.
/// @param speed  at which it begins, up the board [m/s], not negative
/// @throws std::invalid_argument if `speed` is negative, nothing would stop the box (`angle` and mu_k are both 0), or for
///         what `incline_acceleration` refuses.
UpAndBack up_and_back(const Box &box, double speed, double angle, double g);

//> A spring, and what it pulls
/// A spring whose right end is pulled to the right, always at the same speed. Its left end is fixed to a box.
struct Spring {
    double stiffness{}; ///< its force for each metre of stretch [N/m], more than 0
    double speed{};     ///< of its right end [m/s]
    COURSE_FIELDS("N/m, m/s", stiffness, speed)
};
/// A box on level ground that is pulled by a spring.
struct Pulled {
    double position{}; ///< of the box [m]
    double velocity{}; ///< of the box [m/s]
    double stretch{};  ///< of the spring [m]; negative: it is pressed together, and pushes to the left
    COURSE_FIELDS("m, m/s, m", position, velocity, stretch)
};

//> Stick or slip
/// A box that is pulled by a spring, one frame later. First its velocity changes:
/// at rest it stays at rest, as long as the spring's force is not larger than mu_s times the normal force;
/// otherwise the spring accelerates it for `dt`, and then kinetic friction takes from its speed, as in `apply_friction`.
/// Then the box moves at this velocity for `dt`, and the stretch grows by how much further the right end has moved.
/// Where the box is just held, up to rounding, either is right. A velocity or mu_k · g beyond ±1e5 may be refused.
/// @param dt  length of the frame [s], not negative
/// @throws std::invalid_argument if `box` is not as `Box` says, `stiffness` or `g` is not positive, `dt` is negative, or a
///         number is not within ±1e5.
Pulled stick_slip_step(const Pulled &before, const Box &box, const Spring &spring, double g, double dt);

//> The exercises
namespace subject {
COURSE_EXERCISE("5.1", core, inclined_planes, stopping_distance, "velocity [m/s], deceleration [m/s²]", "m")
COURSE_EXERCISE("5.2", core, inclined_planes, apply_friction, "velocity [m/s], deceleration [m/s²], dt [s]", "m/s")
COURSE_EXERCISE("5.3", core, inclined_planes, normal_force, "mass [kg], angle [rad], g [m/s²]", "N")
COURSE_EXERCISE("5.4", core, inclined_planes, incline_acceleration, "box, angle [rad], g [m/s²]", "m/s²")
COURSE_EXERCISE("5.5", core, inclined_planes, critical_angle, "mu_s [1]", "rad")
COURSE_EXERCISE("5.6", stretch, inclined_planes, table_friction, "velocity [m/s], deceleration [m/s²], dt [s]", "m/s")
COURSE_EXERCISE("5.7", stretch, inclined_planes, up_and_back, "box, speed [m/s], angle [rad], g [m/s²]", "")
COURSE_EXERCISE("5.8", challenge, inclined_planes, stick_slip_step, "before, box, spring, g [m/s²], dt [s]", "")
} // namespace subject
//>
} // namespace inclined_planes
