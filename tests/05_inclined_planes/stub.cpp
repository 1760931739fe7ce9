// Section 5, Inclined planes. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 5
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "inclined_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace inclined_planes {

// 5.1 core
double stopping_distance(double velocity, double deceleration) {
    course::require(deceleration > 0, "deceleration [m/s²] must be positive", deceleration);
    throw course::NotYet{"how long does it slide, and how fast is it on average?"};
}

static void require_frame(double deceleration, double dt) {
    course::require(deceleration >= 0, "deceleration [m/s²] must not be negative", deceleration);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

// 5.2 core
double apply_friction(double velocity, double deceleration, double dt) {
    require_frame(deceleration, dt);
    throw course::NotYet{"how much speed does friction take in this frame?"};
}

static void require_board(double mass, double angle, double g) {
    course::require(mass > 0, "mass [kg] must be positive", mass);
    course::require(angle >= 0 && angle <= std::numbers::pi / 2, "angle [rad] must be from 0 to π/2", angle);
    course::require(g > 0, "g [m/s²] must be positive", g);
}

// 5.3 core
double normal_force(double mass, double angle, double g) {
    require_board(mass, angle, g);
    throw course::NotYet{"how heavy is the box, and which part of that presses into the board?"};
}

static void require_box(const Box &box, double angle, double g) {
    require_board(box.mass, angle, g);
    course::require(box.mu_k >= 0, "mu_k must not be negative", box.mu_k);
    course::require(box.mu_s >= box.mu_k, "mu_s must not be less than mu_k", box.mu_s);
}

// 5.4 core
double incline_acceleration(const Box &box, double angle, double g) {
    require_box(box, angle, g);
    throw course::NotYet{"what pulls the box down the board, and how hard can friction hold it?"};
}

// 5.5 core
double critical_angle(double mu_s) {
    course::require(mu_s >= 0, "mu_s must not be negative", mu_s);
    throw course::NotYet{"at this angle, the pull down the board is as large as friction can be"};
}

// 5.6 stretch
Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt) {
    require_frame(deceleration, dt);
    throw course::NotYet{"what does 5.2 make of each component?"};
}

// 5.7 stretch
UpAndBack up_and_back(const Box &box, double speed, double angle, double g) {
    require_box(box, angle, g);
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    course::require(angle > 0 || box.mu_k > 0, "something must stop the box: angle or mu_k", angle);
    throw course::NotYet{"which two forces slow the box down on its way up?"};
}

// 5.8 challenge
Pulled stick_slip_step(const Pulled &before, const Box &box, const Spring &spring, double g, double dt) {
    require_box(box, 0, g);
    course::require(spring.stiffness > 0, "stiffness [N/m] must be positive", spring.stiffness);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    throw course::NotYet{"how hard does the spring pull? Does the box rest, and does friction hold it?"};
}

} // namespace inclined_planes
