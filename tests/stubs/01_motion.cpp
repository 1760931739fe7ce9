// Section 1, Motion. Replace a whole `throw ...;` by your own code, save, and see:  ./course check 1
// Bad input is refused in a line or two, as in the first function; the others need such lines as well.

#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace motion {

// 1.1 core
double px_per_second(double px_per_frame, double frames_per_second) {
    course::require_range(px_per_frame, frames_per_second);
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    throw course::NotYet{"each frame moves it on, and a second has so many frames: return their ..."};
}

// 1.2 core
Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    throw course::NotYet{"how far does it go in one second? And in t of them? It does not begin at (0, 0)"};
}

// 1.3 core
State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    throw course::NotYet{"how fast is it after t, and how fast was it on average until then?"};
}

// 1.4 core
std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    throw course::NotYet{"add up the masses, and the positions times their masses, in one loop"};
}

// 1.5 stretch
Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
    throw course::NotYet{"each scheme gains the same velocity in a step; with which one does it move?"};
}

// 1.6 stretch
Vec2 centroid(const std::vector<Vec2> &corners) {
    throw course::NotYet{"cut the plate into triangles that share its first corner; the middle of each is known"};
}

// 1.7 challenge
Law law_of_motion(const Sample &first, const Sample &second, const Sample &third) {
    throw course::NotYet{"how fast was it on average between two looks, and at which moment was it just so fast?"};
}

} // namespace motion
