// 11.7: int cuts off what follows the point
#include "particles.hpp"

namespace particles {

Due due(double rate, double carry, double dt) {
    course::require_range(rate, carry, dt);
    if (rate < 0 || dt < 0 || carry < 0 || carry >= 1 || rate * dt > 1e6) throw std::invalid_argument{"no such rate"};
    const double all = rate * dt + carry;
    const int count = static_cast<int>(all);
    return {count, all - count};
}

} // namespace particles
