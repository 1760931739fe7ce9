// 11.7: what the frame adds, whole and broken; then the two broken ones
#include "particles.hpp"

#include <cmath>

namespace particles {

Due due(double rate, double carry, double dt) {
    course::require_range(rate, carry, dt);
    if (rate < 0 || dt < 0 || carry < 0 || carry >= 1 || rate * dt > 1e6) throw std::invalid_argument{"no such rate"};
    double whole = 0;
    double broken = std::modf(rate * dt, &whole) + carry;
    if (broken >= 1) {
        broken -= 1;
        whole += 1;
    }
    return {.count = int(whole), .carry = broken};
}

} // namespace particles
