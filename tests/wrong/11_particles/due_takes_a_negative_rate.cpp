// 11.7: a negative rate is not refused
#include "particles.hpp"

#include <cmath>

namespace particles {

Due due(double rate, double carry, double dt) {
    course::require_range(rate, carry, dt);
    course::require(carry >= 0 && carry < 1, "carry must be in [0, 1)", carry);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(rate * dt <= 1e6, "rate times dt must be at most 1e6", rate * dt);

    const double all = carry + rate * dt;
    const double whole = std::floor(all);
    return {.count = int(whole), .carry = all - whole};
}

} // namespace particles
