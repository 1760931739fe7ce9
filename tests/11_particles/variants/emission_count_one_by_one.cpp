// 11.7: it takes one particle away as long as a whole one is left
#include "particles.hpp"

namespace particles {

Emission emission_count(double rate, double remainder, double dt) {
    if (rate < 0 || dt < 0 || remainder < 0 || remainder >= 1 || rate * dt > 1e6)
        throw std::invalid_argument{"no such rate"};
    Emission due{0, remainder + rate * dt};
    for (; due.remainder >= 1; due.remainder -= 1) ++due.count;
    return due;
}

} // namespace particles
