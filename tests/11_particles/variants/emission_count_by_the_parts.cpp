// 11.7: the whole part and the fraction of what the frame adds; then the fraction and the old remainder together
#include "particles.hpp"

#include <cmath>

namespace particles {

Emission emission_count(double rate, double remainder, double dt) {
    if (rate < 0 || dt < 0 || remainder < 0 || remainder >= 1 || rate * dt > 1e6)
        throw std::invalid_argument{"no such rate"};
    double whole = 0;
    double fraction = std::modf(rate * dt, &whole) + remainder;
    if (fraction >= 1) {
        fraction -= 1;
        whole += 1;
    }
    return {.count = int(whole), .remainder = fraction};
}

} // namespace particles
