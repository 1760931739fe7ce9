// Section 4, Trajectories. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 4
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "trajectories.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trajectories {

// 4.1 core
Vec2 launch_velocity(double speed, double angle_deg) {
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    throw course::NotYet{"which angle is that in radians? How much of the speed goes to the right, and how much up?"};
}

static void require_g(double g) { course::require(g > 0, "g [m/s²] must be positive", g); }
static void require_above_ground(const State &muzzle) {
    course::require(muzzle.position.y() >= 0, "the muzzle's height [m] must not be negative", muzzle.position.y());
}

// 4.2 core
double time_of_flight(const State &muzzle, double g) {
    require_g(g);
    require_above_ground(muzzle);
    throw course::NotYet{"how long does it rise, and how long does it fall?"};
}

// 4.3 core
double range(const State &muzzle, double g) {
    require_g(g);
    require_above_ground(muzzle);
    throw course::NotYet{"how fast does it move to the right, and for how long?"};
}

// 4.4 core
Vec2 apex(const State &muzzle, double g) {
    require_g(g);
    throw course::NotYet{"how long does it rise, and how far does it get in that time, to the right and up?"};
}

static void require_frames(const State &muzzle, double g, double dt) {
    course::require(dt > 0, "dt [s] must be positive", dt);
    const double t = gravity_wells::time_to_fall(muzzle.position.y(), muzzle.velocity.y(), g);
    course::require(t / dt <= 10000 + 1e-6, "the flight must not take more than 10 000 dt", t / dt);
}

// 4.5 core
std::vector<Vec2> dotted_arc(const State &muzzle, double g, double dt) {
    require_g(g);
    require_above_ground(muzzle);
    require_frames(muzzle, g, dt);
    throw course::NotYet{"start with an empty list; where is the shell after dt seconds? Is it still in the air?"};
}

// 4.6 stretch
double range_in_wind(const State &muzzle, double g, double wind) {
    require_g(g);
    require_above_ground(muzzle);
    throw course::NotYet{"how long is it in the air, and how far does the wind push it in that time?"};
}

// 4.7 stretch
std::optional<double> range_at_height(const State &muzzle, double g, double height) {
    require_g(g);
    throw course::NotYet{"how fast is it, up and down, when it comes through that height? Is there such a speed?"};
}

// 4.8 challenge
std::vector<double> launch_angles(double speed, const Vec2 &target, double g) {
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    course::require(target.x() > 0, "target.x() [m] must be positive", target.x());
    course::require(g > 0, "g [m/s²] must be positive", g);
    throw course::NotYet{
        "write the arc's height above target.x() with the tangent of the angle: it is a quadratic equation"};
}

// 4.9 challenge
LoopRanges frame_loop_ranges(const State &muzzle, double g, double dt) {
    require_g(g);
    require_above_ground(muzzle);
    require_frames(muzzle, g, dt);
    course::require(muzzle.velocity.y() > g * dt, "the shell must still rise after its first frame",
                    muzzle.velocity.y() - g * dt);
    throw course::NotYet{"move it until a frame ends at or below the ground; where is the ground on that last line?"};
}

// 4.10 stretch
State drag_step(const State &shell, double g, double drag, const Vec2 &wind, double dt) {
    course::require(g >= 0, "g [m/s²] must not be negative", g);
    course::require(drag >= 0, "drag [1/m] must not be negative", drag);
    course::require(dt > 0, "dt [s] must be positive", dt);
    throw course::NotYet{"how fast is it relative to the air? What does the step leave of that, and of g?"};
}

} // namespace trajectories
