#pragma once
#include "../course.hpp"
#include "../interface.hpp"

/// Section 5: friction, on level ground and on a slope: what stops, what holds, and what slides.
/// Numbers that go in are within ±1e5, both ends included; an answer may be larger. Twelve digits must
/// be right; where fewer will do, the tests say.
namespace inclined_planes {

using course::Vec2;

//> Stopping distance
/// How far a puck slides before it stops [m]: positive to the right, negative to the left.
/// @param velocity      [m/s], positive to the right
/// @param deceleration  how much speed friction takes each second [m/s²], more than 0
/// @throws std::invalid_argument if `deceleration` is not positive.
double stopping_distance(double velocity, double deceleration);

//> One frame of friction
/// A puck's velocity one frame later [m/s]. Friction takes `deceleration` times `dt` off its speed, and never more than
/// there is: a stopped puck's velocity is exactly 0, and it stays 0.
/// @param velocity      [m/s], positive to the right
/// @param deceleration  how much speed friction takes each second [m/s²], not negative
/// @param dt            length of the frame [s], not negative
/// @throws std::invalid_argument if `deceleration` or `dt` is negative.
double apply_friction(double velocity, double deceleration, double dt);

//> Normal force
/// How hard a box and its board press against each other [N].
/// @param mass   [kg], more than 0
/// @param angle  of the board [rad]: 0 is level, π/2 upright
/// @param g      how much faster a falling thing gets each second [m/s²], more than 0
/// @throws std::invalid_argument if `mass` or `g` is not positive, or `angle` is not from 0 to π/2.
double normal_force(double mass, double angle, double g);

//> A box
/// A box, and how rough it is on its board.
struct Box {
    double mass{}; ///< [kg], more than 0
    double mu_s{}; ///< coefficient of static friction, until it slips [1], not less than mu_k
    double mu_k{}; ///< coefficient of kinetic friction, while it slides [1], not negative
    COURSE_FIELDS("kg, 1, 1", mass, mu_s, mu_k)
};

//> Acceleration on an incline
/// You put a box down on a board and let go: its acceleration down the board [m/s²], or 0 when friction holds it.
/// A pull that's exactly as large as static friction can be is still held.
/// @param angle  of the board [rad]: 0 is level, π/2 upright
/// @throws std::invalid_argument if `box` is not as `Box` says, or for what `normal_force` refuses.
double incline_acceleration(const Box &box, double angle, double g);

//> Critical angle
/// The steepest angle at which a box that you put down still stays put [rad]. At exactly that angle rounding decides, and
/// `incline_acceleration` may let it slide, as ours does for one mu_s in four; 1e-9 rad below, it's held.
/// @param mu_s  coefficient of static friction [1], not negative
/// @throws std::invalid_argument if `mu_s` is negative.
double critical_angle(double mu_s);

//> Friction on a table
/// A puck's velocity one frame later, on a table seen from above [m/s]. Friction takes `deceleration` times `dt` off its
/// speed, never more than there is, and never turns it.
/// @param velocity  [m/s], positive to the right, and away from you
/// @throws std::invalid_argument for what `apply_friction` refuses.
Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt);

//> Up and back
/// What happens to a box pushed up a board.
struct UpAndBack {
    double up{};   ///< how far it slides up the board [m]
    double back{}; ///< its speed when it's back where it started [m/s]; 0 when it stays up there
    COURSE_FIELDS("m, m/s", up, back)
};

//> Up a board, and back or not
/// How far a box slides up a board, and how fast it comes back. Up there it stays, or slides, as in
/// `incline_acceleration`.
/// @param speed  at the start, up the board [m/s], not negative
/// @throws std::invalid_argument if `speed` is negative, nothing would stop the box (`angle` and mu_k are both 0), or for
///         what `incline_acceleration` refuses.
UpAndBack up_and_back(const Box &box, double speed, double angle, double g);

//> A spring, and what it pulls
/// A spring tied to a box by its left end. Its right end is pulled to the right at constant speed.
struct Spring {
    double stiffness{}; ///< its force for each metre of stretch [N/m], more than 0
    double speed{};     ///< of its right end [m/s]
    COURSE_FIELDS("N/m, m/s", stiffness, speed)
};
/// A box on level ground, pulled by a spring.
struct Pulled {
    double position{}; ///< of the box [m]
    double velocity{}; ///< of the box [m/s]
    double stretch{};  ///< of the spring [m]; negative: it's squeezed, and pushes to the left
    COURSE_FIELDS("m, m/s, m", position, velocity, stretch)
};

//> Stick or slip
/// A box on a spring, one frame later. First its velocity changes. A box that isn't moving sticks as long as the spring's
/// force isn't larger than mu_s times the normal force. Any other is accelerated by the spring for `dt`, and then kinetic
/// friction takes off speed, as in `apply_friction`. Last, the box moves at its new velocity for `dt`, and the stretch
/// grows by how much farther the spring's right end moved.
/// @param dt  length of the frame [s], not negative
/// @throws std::invalid_argument if `box` is not as `Box` says, `stiffness` or `g` is not positive, or `dt` is negative.
Pulled stick_slip_step(const Pulled &before, const Box &box, const Spring &spring, double g, double dt);

//>
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
} // namespace inclined_planes
