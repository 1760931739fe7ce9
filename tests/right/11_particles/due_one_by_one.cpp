// 11.7: it takes one away as long as there is one
#include "particles.hpp"

namespace particles {

Due due(double rate, double carry, double dt) {
    course::require_range(rate, carry, dt);
    if (rate < 0 || dt < 0 || carry < 0 || carry >= 1 || rate * dt > 1e6) throw std::invalid_argument{"no such rate"};
    Due due{0, carry + rate * dt};
    for (; due.carry >= 1; due.carry -= 1) ++due.count;
    return due;
}

} // namespace particles
