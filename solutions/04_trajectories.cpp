#include "trajectories.hpp"

#include <numbers>

namespace trajectories {

//> Solution 4.1: launch velocity
Vec2 launch_velocity(double speed, double angle_deg) {
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    const double angle = angle_deg * std::numbers::pi / 180; // [rad]
    return speed * Vec2{std::cos(angle), std::sin(angle)};
}

//> Solution: a good shot
static void require_g(double g) { course::require(g > 0, "g [m/s²] must be positive", g); }
static void require_above_ground(const State &muzzle) {
    course::require(muzzle.position.y() >= 0, "the muzzle's height [m] must not be negative", muzzle.position.y());
}

//> Solution 4.2: time of flight
double time_of_flight(const State &muzzle, double g) {
    require_g(g);
    require_above_ground(muzzle);
    return gravity_wells::time_to_fall(muzzle.position.y(), muzzle.velocity.y(), g);
}

//> Solution 4.3: range
double range(const State &muzzle, double g) {
    require_g(g);
    require_above_ground(muzzle);
    return muzzle.velocity.x() * time_of_flight(muzzle, g);
}

//> Solution 4.4: apex
Vec2 apex(const State &muzzle, double g) {
    require_g(g);
    if (muzzle.velocity.y() <= 0) return muzzle.position;
    const double t = muzzle.velocity.y() / g; // until it rises no more [s]
    return muzzle.position + t * Vec2{muzzle.velocity.x(), muzzle.velocity.y() / 2};
}

//> Solution: good frames
static void require_frames(const State &muzzle, double g, double dt) {
    course::require(dt > 0, "dt [s] must be positive", dt);
    const double t = gravity_wells::time_to_fall(muzzle.position.y(), muzzle.velocity.y(), g);
    course::require(t / dt <= 10000 + 1e-6, "the flight must not take more than 10 000 dt", t / dt);
}

//> Solution 4.5: dotted arc
std::vector<Vec2> dotted_arc(const State &muzzle, double g, double dt) {
    require_g(g);
    require_above_ground(muzzle);
    require_frames(muzzle, g, dt);
    const double landing = time_of_flight(muzzle, g);
    std::vector<Vec2> arc;
    for (int i = 0; i * dt < landing; ++i) {
        const double t = i * dt;
        arc.push_back(muzzle.position + t * muzzle.velocity + t * t / 2 * Vec2{0, -g});
    }
    arc.push_back({muzzle.position.x() + range(muzzle, g), 0});
    return arc;
}

//> Solution 4.6: range in wind
double range_in_wind(const State &muzzle, double g, double wind) {
    require_g(g);
    require_above_ground(muzzle);
    const double t = time_of_flight(muzzle, g);
    return muzzle.velocity.x() * t + wind * t * t / 2;
}

//> Solution 4.7: range at a height
std::optional<double> range_at_height(const State &muzzle, double g, double height) {
    require_g(g);
    const double up = muzzle.velocity.y();
    const double square = up * up + 2 * g * (muzzle.position.y() - height); // of its vertical speed there [m²/s²]
    if (square < 0) return {};
    const double t = (up + std::sqrt(square)) / g;
    if (t < 0) return {};
    return muzzle.velocity.x() * t;
}

//> Solution 4.8: launch angles
std::vector<double> launch_angles(double speed, const Vec2 &target, double g) {
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    course::require(target.x() > 0, "target.x() [m] must be positive", target.x());
    course::require(g > 0, "g [m/s²] must be positive", g);
    const double x = target.x(), y = target.y();
    const double k = g * x * x / (2 * speed * speed); // how far it falls on its way, if aimed level [m]
    const double square = x * x - 4 * k * (y + k);
    if (!(square >= 0)) return {};
    const auto degrees = [](double angle) { return angle * 180 / std::numbers::pi; };
    const double high = degrees(std::atan((x + std::sqrt(square)) / (2 * k)));
    const double low = degrees(std::atan((x - std::sqrt(square)) / (2 * k)));
    if (low == high) return {low};
    return {low, high};
}

//> Solution 4.9: where a frame crosses the ground
static double crossing(const Vec2 &before, const Vec2 &after) {
    const double part = before.y() / (before.y() - after.y()); // of the last frame
    return before.x() + part * (after.x() - before.x());
}

//> Solution 4.9: frame loop ranges
LoopRanges frame_loop_ranges(const State &muzzle, double g, double dt) {
    require_g(g);
    require_above_ground(muzzle);
    require_frames(muzzle, g, dt);
    course::require(muzzle.velocity.y() > g * dt, "the shell must still rise after its first frame",
                    muzzle.velocity.y() - g * dt);
    const auto range_of = [&](State motion::Integrators::*shell) {
        motion::Integrators before, now{muzzle, muzzle, muzzle};
        do {
            before = now;
            now = motion::step_all(before, {0, -g}, dt);
        } while ((now.*shell).position.y() > 0);
        return crossing((before.*shell).position, (now.*shell).position) - muzzle.position.x();
    };
    return {range_of(&motion::Integrators::explicit_euler), range_of(&motion::Integrators::semi_implicit),
            range_of(&motion::Integrators::exact)};
}

//> Solution 4.10: drag step
State drag_step(const State &shell, double g, double drag, const Vec2 &wind, double dt) {
    course::require(g >= 0, "g [m/s²] must not be negative", g);
    course::require(drag >= 0, "drag [1/m] must not be negative", drag);
    course::require(dt > 0, "dt [s] must be positive", dt);
    const Vec2 relative = shell.velocity - wind; // to the air [m/s]
    const Vec2 slowed = (relative + dt * Vec2{0, -g}) / (1 + drag * relative.norm() * dt);
    const Vec2 velocity = wind + slowed;
    return {shell.position + dt / 2 * (shell.velocity + velocity), velocity};
}
//>
} // namespace trajectories
