// 11.7: waits for one particle after the other, as a beginner writes it: a million of them add a million roundings
#include "particles.hpp"

#include <algorithm>
#include <cmath>

namespace particles {

Emission emission_count(double rate, double remainder, double dt) {
    if (rate < 0 || dt < 0 || remainder < 0 || remainder >= 1 || rate * dt > 1e6)
        throw std::invalid_argument{"no such rate"};
    if (rate == 0) return {0, remainder};
    int count = 0;
    for (double wait = (1 - remainder) / rate; wait <= dt; wait = 1 / rate) {
        dt -= wait;
        remainder = 0;
        ++count;
    }
    return {count, std::min(remainder + dt * rate, std::nextafter(1.0, 0.0))};
}

} // namespace particles
