// Section 1, Motion. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 1
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace motion {

// 1.1 core
double px_per_second(double px_per_frame, double frames_per_second) {
    throw course::NotYet{"how many pixels does it move in one frame, and how many frames are there in a second?"};
}

// 1.2 core
Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    throw course::NotYet{"how far does it move in one second? And in t seconds? And where did it start?"};
}

// 1.3 core
State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    throw course::NotYet{"how fast is it at time t, and how fast was it on average until then?"};
}

// 1.4 core
std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    throw course::NotYet{"in one loop, add up the masses, and the positions times their masses"};
}

// 1.5 stretch
Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    throw course::NotYet{"all three gain the same velocity in a step; at which velocity does each of them move?"};
}

// 1.6 challenge
Vec2 centroid(const std::vector<Vec2> &corners) {
    course::require(corners.size() >= 3, "the number of corners must be three or more", double(corners.size()));
    double size = 0; // the square of the longest distance between two corners [m²]
    for (const Vec2 &p : corners)
        for (const Vec2 &q : corners) size = std::max(size, (p - q).squaredNorm());
    // This line refuses corners on one line. Put it between your loop and your `return`, without its two slashes:
    // course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    throw course::NotYet{"cut the plate into triangles that share its first corner; you know the centroid of each"};
}

// 1.7 stretch
Motion fit_motion(const Sample &first, const Sample &second, const Sample &third) {
    const char *claim = "the times [s] must differ from each other";
    course::require(first.t != second.t && first.t != third.t, claim, first.t);
    course::require(second.t != third.t, claim, second.t);
    throw course::NotYet{"what was its average velocity between two samples, and when did it move at exactly that?"};
}

// 1.8 stretch
Vec2 to_screen(const Vec2 &place, const Screen &screen) {
    course::require(screen.px_per_m > 0, "px_per_m must be positive", screen.px_per_m);
    throw course::NotYet{"how many pixels is the place away from the middle of the screen?"};
}

} // namespace motion
