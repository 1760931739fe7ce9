// One that's right.
#include "motion.hpp"

static double helper(double x) { return x; }
double of_the_same_name(double x) { return helper(x); }

namespace motion {

Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    return start + of_the_same_name(t) * velocity;
}

} // namespace motion
