// 11.7: what the frame adds, whole and broken; then the two broken ones
#include "particles.hpp"

#include <cmath>

namespace particles {

Emission emission_count(double rate, double remainder, double dt) {
    course::require_range(rate, remainder, dt);
    if (rate < 0 || dt < 0 || remainder < 0 || remainder >= 1 || rate * dt > 1e6)
        throw std::invalid_argument{"no such rate"};
    double whole = 0;
    double broken = std::modf(rate * dt, &whole) + remainder;
    if (broken >= 1) {
        broken -= 1;
        whole += 1;
    }
    return {.count = int(whole), .remainder = broken};
}

} // namespace particles
