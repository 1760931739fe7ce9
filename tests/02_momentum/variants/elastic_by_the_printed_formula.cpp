// 2.2: the formula that physics books print
#include "momentum.hpp"

#include <stdexcept>

namespace momentum {

Velocities elastic_collision(const Cart &a, const Cart &b) {
    if (!(a.mass > 0) || !(b.mass > 0)) throw std::invalid_argument{"mass"};
    if (b.velocity >= a.velocity) return {a.velocity, b.velocity};
    const double total = a.mass + b.mass;
    return {(2 * b.mass * b.velocity + a.velocity * (a.mass - b.mass)) / total,
            (2 * a.mass * a.velocity - b.velocity * (a.mass - b.mass)) / total};
}

} // namespace momentum
