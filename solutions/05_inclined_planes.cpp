#include "inclined_planes.hpp"

#include <algorithm>
#include <numbers>

namespace inclined_planes {

//> Solution 5.1: stopping distance
double stopping_distance(double velocity, double deceleration) {
    course::require(deceleration > 0, "deceleration [m/s²] must be positive", deceleration);
    const double t = std::abs(velocity) / deceleration; // until it rests [s]
    return velocity / 2 * t;
}

//> Solution: a good frame
static void require_frame(double deceleration, double dt) {
    course::require(deceleration >= 0, "deceleration [m/s²] must not be negative", deceleration);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

//> Solution 5.2: one frame of friction
double apply_friction(double velocity, double deceleration, double dt) {
    require_frame(deceleration, dt);
    const double loss = deceleration * dt; // of speed [m/s]
    if (velocity > loss) return velocity - loss;
    if (velocity < -loss) return velocity + loss;
    return 0; // it stops in this frame, or rests already
}

//> Solution: a good board
static void require_board(double mass, double angle, double g) {
    course::require(mass > 0, "mass [kg] must be positive", mass);
    course::require(angle >= 0 && angle <= std::numbers::pi / 2, "angle [rad] must be from 0 to π/2", angle);
    course::require(g > 0, "g [m/s²] must be positive", g);
}

//> Solution 5.3: normal force
double normal_force(double mass, double angle, double g) {
    require_board(mass, angle, g);
    return mass * g * std::cos(angle);
}

//> Solution: a good box
static void require_box(const Box &box, double angle, double g) {
    require_board(box.mass, angle, g);
    course::require(box.mu_k >= 0, "mu_k must not be negative", box.mu_k);
    course::require(box.mu_s >= box.mu_k, "mu_s must not be less than mu_k", box.mu_s);
}

//> Solution 5.4: acceleration on an incline
double incline_acceleration(const Box &box, double angle, double g) {
    require_box(box, angle, g);
    const double pull = box.mass * g * std::sin(angle); // down the board [N]
    const double normal = normal_force(box.mass, angle, g);
    if (pull <= box.mu_s * normal) return 0;
    return (pull - box.mu_k * normal) / box.mass;
}

//> Solution 5.5: critical angle
double critical_angle(double mu_s) {
    course::require(mu_s >= 0, "mu_s must not be negative", mu_s);
    return std::atan(mu_s);
}

//> Solution 5.6: friction on a table
Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt) {
    require_frame(deceleration, dt);
    const double speed = velocity.norm(), loss = deceleration * dt;
    if (speed <= loss) return {0, 0};
    return (speed - loss) / speed * velocity;
}

//> Solution 5.7: up and back
UpAndBack up_and_back(const Box &box, double speed, double angle, double g) {
    require_box(box, angle, g);
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    course::require(angle > 0 || box.mu_k > 0, "something must stop the box: angle or mu_k", angle);
    const double friction = box.mu_k * normal_force(box.mass, angle, g) / box.mass; // [m/s²]
    const double up = speed * speed / (2 * (g * std::sin(angle) + friction));
    return {up, std::sqrt(2 * incline_acceleration(box, angle, g) * up)};
}

//> Solution 5.8: stick or slip
Pulled stick_slip_step(const Pulled &before, const Box &box, const Spring &spring, double g, double dt) {
    require_box(box, 0, g);
    course::require(spring.stiffness > 0, "stiffness [N/m] must be positive", spring.stiffness);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    const double pull = spring.stiffness * before.stretch; // [N]
    const bool sticks = before.velocity == 0 && std::abs(pull) <= box.mu_s * box.mass * g;
    const double velocity = sticks ? 0 : apply_friction(before.velocity + pull / box.mass * dt, box.mu_k * g, dt);
    return {before.position + velocity * dt, velocity, before.stretch + (spring.speed - velocity) * dt};
}
//>
} // namespace inclined_planes
