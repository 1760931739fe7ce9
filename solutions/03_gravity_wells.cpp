#include "gravity_wells.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace gravity_wells {

//> Solution 3.1: gravity
Vec2 gravity(const PointMass &body, const PointMass &other, double G) {
    course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    course::require(other.mass >= 0, "mass [kg] must not be negative", other.mass);
    course::require(G >= 0, "G [N m²/kg²] must not be negative", G);
    const Vec2 towards = other.position - body.position;
    const double r = towards.norm();
    if (r == 0) return {0, 0};
    return G * body.mass * other.mass / (r * r) * (towards / r);
}

//> Solution: a good fall
static void require_fall(double height, double g) {
    course::require(height >= 0, "height [m] must not be negative", height);
    course::require(g > 0, "g [m/s²] must be positive", g);
}

//> Solution 3.2: time to fall
double time_to_fall(double height, double velocity, double g) {
    require_fall(height, g);
    const double impact = std::sqrt(velocity * velocity + 2 * g * height); // how fast it hits the floor [m/s]
    return (velocity + impact) / g;
}

//> Solution 3.3: fall and land
Fall fall_and_land(const Fall &now, double g, double dt) {
    require_fall(now.height, g);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    const double t = time_to_fall(now.height, now.velocity, g);
    if (t <= dt) return {0, now.velocity - g * t, now.time + t};
    return {now.height + now.velocity * dt - g * dt * dt / 2, now.velocity - g * dt, now.time + dt};
}

//> Solution 3.4: circular orbit
double circular_orbit_speed(double mass, double radius, double G) {
    course::require(mass >= 0, "mass [kg] must not be negative", mass);
    course::require(radius > 0, "radius [m] must be positive", radius);
    course::require(G >= 0, "G [N m²/kg²] must not be negative", G);
    return std::sqrt(G * mass / radius);
}

//> Solution: a good step
static void require_step(double mu, double dt) {
    course::require(mu >= 0, "mu [m³/s²] must not be negative", mu);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

//> Solution 3.5: one step of an orbit
State orbit_step(const State &ship, double mu, double dt) {
    require_step(mu, dt);
    const Vec2 acceleration = gravity({ship.position, 1}, {{0, 0}, mu}, 1);
    const Vec2 velocity = ship.velocity + dt * acceleration;
    return {ship.position + dt * velocity, velocity};
}

//> Solution 3.6: softened gravity
Vec2 softened_gravity(const Vec2 &position, double mu, double epsilon) {
    course::require(mu >= 0, "mu [m³/s²] must not be negative", mu);
    course::require(epsilon > 0, "epsilon [m] must be positive", epsilon);
    const double softened = std::sqrt(position.squaredNorm() + epsilon * epsilon);
    return -mu / (softened * softened * softened) * position;
}

//> Solution: the pull of a well
/// The acceleration of a ship in a well at (0, 0) [m/s²].
static Vec2 pull_at(const Vec2 &position, double mu) {
    const double distance = position.norm();
    if (distance == 0) return {0, 0};
    return -mu / (distance * distance) * (position / distance);
}

//> Solution 3.7: leapfrog
static State leapfrog_step(const State &ship, double mu, double dt) {
    const Vec2 halfway = ship.velocity + dt / 2 * pull_at(ship.position, mu); // the velocity in the middle of the step
    const Vec2 position = ship.position + dt * halfway;
    return {position, halfway + dt / 2 * pull_at(position, mu)};
}

//> Solution 3.7: Runge–Kutta
/// A state that has gone along this slope for so long [s].
static State along(const State &from, const State &slope, double time) {
    return {from.position + time * slope.position, from.velocity + time * slope.velocity};
}

static State slope_at(const State &ship, double mu) { return {ship.velocity, pull_at(ship.position, mu)}; }

static State runge_kutta_step(const State &ship, double mu, double dt) {
    const State k1 = slope_at(ship, mu);
    const State k2 = slope_at(along(ship, k1, dt / 2), mu);
    const State k3 = slope_at(along(ship, k2, dt / 2), mu);
    const State k4 = slope_at(along(ship, k3, dt), mu);
    State after = along(ship, k1, dt / 6);
    after = along(after, k2, dt / 3);
    after = along(after, k3, dt / 3);
    return along(after, k4, dt / 6);
}

//> Solution 3.7: all four
Integrators step_all(const Integrators &before, double mu, double dt) {
    require_step(mu, dt);
    Integrators after;
    after.explicit_euler = along(before.explicit_euler, slope_at(before.explicit_euler, mu), dt);
    after.semi_implicit = orbit_step(before.semi_implicit, mu, dt);
    after.leapfrog = leapfrog_step(before.leapfrog, mu, dt);
    after.runge_kutta = runge_kutta_step(before.runge_kutta, mu, dt);
    return after;
}

//> Solution 3.8: Kepler's equation
/// The angle E for which E - eccentricity sin(E) is `mean` [rad], by Newton's method.
static double eccentric_anomaly(double mean, double eccentricity) {
    double angle = std::copysign(std::numbers::pi, mean); // from here it cannot overshoot
    for (int i = 0; i < 60; ++i)
        angle -= (angle - eccentricity * std::sin(angle) - mean) / (1 - eccentricity * std::cos(angle));
    return angle;
}

//> Solution 3.8: Kepler's ellipse
Vec2 kepler_position(double semi_major, double eccentricity, double mu, double t) {
    course::require(semi_major > 0, "semi_major [m] must be positive", semi_major);
    course::require(0 <= eccentricity && eccentricity < 1, "eccentricity must be from 0 to less than 1", eccentricity);
    course::require(mu > 0, "mu [m³/s²] must be positive", mu);
    const double turns = std::sqrt(mu / semi_major) / semi_major * t; // the even angle [rad]
    const double angle = eccentric_anomaly(std::remainder(turns, 2 * std::numbers::pi), eccentricity);
    return {semi_major * (std::cos(angle) - eccentricity),
            semi_major * std::sqrt(1 - eccentricity * eccentricity) * std::sin(angle)};
}

//> Solution: a good flight
static void require_lander(const Lander &now, const Controls &controls, double g, double dt) {
    require_fall(now.state.position.y(), g);
    course::require(now.fuel >= 0, "fuel [s] must not be negative", now.fuel);
    course::require(std::abs(controls.jets) <= 1, "jets must be -1, 0 or 1", controls.jets);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

//> Solution 3.9: when it touches
/// How long something at this height, with this velocity and acceleration upwards, takes to the ground [s].
static double time_to_touch(double height, double velocity, double acceleration) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const bool rises = velocity > 0 || (velocity == 0 && acceleration > 0);
    if (height == 0 && !rises) return 0;
    if (acceleration >= 0 && velocity >= 0) return never;
    if (height == 0) return -2 * velocity / acceleration;
    const double square = velocity * velocity - 2 * acceleration * height; // of how fast it'd touch [m²/s²]
    return square < 0 ? never : 2 * height / (std::sqrt(square) - velocity);
}

//> Solution 3.9: fly a lander
Lander fly_lander(Lander now, const Controls &controls, double pad, double g, double dt) {
    require_lander(now, controls, g, dt);
    bool over = now.landed || now.crashed;
    while (!over) { // until what happens next: the touch, the fuel's end or the frame's
        const bool burns = controls.engine && now.fuel > 0;
        const Vec2 acceleration{controls.jets * jet, burns ? thrust - g : -g};
        const auto &[position, velocity] = now.state;
        const double touch = time_to_touch(position.y(), velocity.y(), acceleration.y());
        const double t = std::min({touch, burns ? now.fuel : dt, dt});
        now.state = motion::accelerated_motion(now.state, acceleration, t);
        now.state.position.y() = t == touch ? 0 : std::max(0.0, now.state.position.y()); // less is rounding
        if (burns) now.fuel -= t;
        dt -= t;
        over = t == touch || dt == 0;
        if (t < touch) continue;
        now.landed = now.state.velocity.norm() <= soft && std::abs(now.state.position.x() - pad) <= half_pad;
        now.crashed = !now.landed;
    }
    return now;
}
//>
} // namespace gravity_wells
