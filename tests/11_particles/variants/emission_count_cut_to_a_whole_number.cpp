// 11.7: int cuts off the digits after the decimal point
#include "particles.hpp"

namespace particles {

Emission emission_count(double rate, double remainder, double dt) {
    if (rate < 0 || dt < 0 || remainder < 0 || remainder >= 1 || rate * dt > 1e6)
        throw std::invalid_argument{"no such rate"};
    const double all = rate * dt + remainder;
    const int count = static_cast<int>(all);
    return {count, all - count};
}

} // namespace particles
