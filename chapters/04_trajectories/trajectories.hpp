#pragma once
#include "../01_motion/motion.hpp"
#include "../03_gravity_wells/gravity_wells.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 4: how a shell flies, and where it lands. The ground is level, at y = 0, unless a function says otherwise.
/// Numbers that go in are within ±1e5; an answer may be larger.
/// Twelve digits must be right, and nine in 4.5 and from 4.7 on; where fewer will do, the tests say.
namespace trajectories {

using course::Vec2;
using motion::State;

//> Launch velocity
/// A shell's velocity as it leaves the muzzle [m/s].
/// @param speed      [m/s], not negative
/// @param angle_deg  what the cannon's dial shows [°]: 0 is to the right, 90 straight up, negative downwards
/// @throws std::invalid_argument if `speed` is negative.
Vec2 launch_velocity(double speed, double angle_deg);

//> Time of flight
/// How long a shell is in the air until it lands [s]; 0 when the muzzle is on the ground and doesn't fire upwards.
/// @param muzzle  where the shell starts, and its velocity there; not below the ground
/// @param g       how much faster it falls each second [m/s²], more than 0
/// @throws std::invalid_argument if the muzzle is below the ground, or `g` is not positive.
double time_of_flight(const State &muzzle, double g);

//> Range
/// How far from the muzzle a shell lands, measured along the ground [m]: positive to the right.
/// `muzzle`, `g` and what's refused: as in `time_of_flight`.
double range(const State &muzzle, double g);

//> Apex
/// The highest point of a shell's flight [m]: the muzzle itself, when it doesn't fire upwards.
/// @param muzzle  where the shell starts, and its velocity there; may be below the ground
/// @throws std::invalid_argument if `g` is not positive.
Vec2 apex(const State &muzzle, double g);

//> Dotted arc
/// Where a shell is after 0, dt, 2 dt, ... seconds, as long as it's in the air, and then where it lands [m].
/// When the muzzle is on the ground and doesn't fire upwards, it's the only point. When dt divides the time of flight,
/// rounding decides whether the landing stands there once or twice: in ours twice for one shot in 20.
/// @param dt  [s], more than 0, and no less than a 10 000th of the time of flight
/// @throws std::invalid_argument if `dt` is not as above, or for what `time_of_flight` refuses.
std::vector<Vec2> dotted_arc(const State &muzzle, double g, double dt);

//> Range in wind
/// How far from the muzzle a shell lands, measured along the ground [m], when a steady wind pushes it all the time.
/// @param wind  how the wind accelerates the shell [m/s²]: positive to the right, whichever way the shell flies
/// @throws std::invalid_argument for what `time_of_flight` refuses.
double range_in_wind(const State &muzzle, double g, double wind);

//> Range at a height
/// How far from the muzzle, measured along the ground, a shell is when it comes down to this height [m].
/// Nothing when it's never that high after it was fired; 0 when the muzzle is that high and doesn't fire upwards.
/// @param height  of the target above the ground, like the muzzle's [m]; either may be higher, or below the ground
/// @throws std::invalid_argument if `g` is not positive.
std::optional<double> range_at_height(const State &muzzle, double g, double height);

//> Launch angles
/// What to set the cannon's dial to so that a shell goes through the target [°]: two angles between -90 and 90, the
/// smaller one first; one, when both are the same; none, when the target is out of reach.
/// @param target  from the muzzle [m], to the right of it: target.x() is more than 0. For one to the left, take its mirror
///                image, and 180 minus each answer.
/// @throws std::invalid_argument if `speed` is negative, or `target.x()` or `g` is not positive.
std::vector<double> launch_angles(double speed, const Vec2 &target, double g);

//> Three ranges
/// How far from the muzzle a shell lands in a game that moves it frame by frame [m], with each integrator of section 1.
struct LoopRanges {
    double explicit_euler{}; ///< it moves at its old velocity
    double semi_implicit{};  ///< it moves at its new velocity
    double exact{};          ///< it moves as constant acceleration moves it
    COURSE_FIELDS("m, m, m", explicit_euler, semi_implicit, exact)
};

//> Frame loop ranges
/// All three ranges. A shell moves until a frame ends at or below the ground. Draw a straight line to there from where
/// it was one frame earlier: it lands where that line crosses the ground.
/// @param dt  of a frame [s], more than 0, and no less than a 10 000th of the time of flight; and so short that the
///            shell, which is fired upwards, still rises at the end of its first frame
/// @throws std::invalid_argument if `dt` is not as above, or for what `time_of_flight` refuses.
LoopRanges frame_loop_ranges(const State &muzzle, double g, double dt);

//> Drag step
/// A shell one step later, in air that slows it down. Its drag is an acceleration against its velocity relative to the air,
/// `drag` times the speed before the step, times the velocity after it, both relative to the air.
/// In the step it moves at the mean of its old and its new velocity. There's no ground.
/// @param g     [m/s²], not negative
/// @param drag  [1/m], not negative; 0 is no air at all
/// @param wind  the velocity of the air [m/s]
/// @param dt    [s], more than 0
/// @throws std::invalid_argument if `g` or `drag` is negative, or `dt` is not positive.
State drag_step(const State &shell, double g, double drag, const Vec2 &wind, double dt);

//>
namespace subject {
COURSE_EXERCISE("4.1", core, trajectories, launch_velocity, "speed [m/s], angle_deg [°]", "m/s")
COURSE_EXERCISE("4.2", core, trajectories, time_of_flight, "muzzle, g [m/s²]", "s")
COURSE_EXERCISE("4.3", core, trajectories, range, "muzzle, g [m/s²]", "m")
COURSE_EXERCISE("4.4", core, trajectories, apex, "muzzle, g [m/s²]", "m")
COURSE_EXERCISE("4.5", core, trajectories, dotted_arc, "muzzle, g [m/s²], dt [s]", "m")
COURSE_EXERCISE("4.6", stretch, trajectories, range_in_wind, "muzzle, g [m/s²], wind [m/s²]", "m")
COURSE_EXERCISE("4.7", stretch, trajectories, range_at_height, "muzzle, g [m/s²], height [m]", "m")
COURSE_EXERCISE("4.8", challenge, trajectories, launch_angles, "speed [m/s], target [m], g [m/s²]", "°")
COURSE_EXERCISE("4.9", challenge, trajectories, frame_loop_ranges, "muzzle, g [m/s²], dt [s]", "")
COURSE_EXERCISE("4.10", stretch, trajectories, drag_step, "shell, g [m/s²], drag [1/m], wind [m/s], dt [s]", "")
} // namespace subject
//>
} // namespace trajectories
