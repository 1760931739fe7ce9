// 8.1: first how hard, then which way
#include "nt_collisions.hpp"

#include <cmath>
#include <stdexcept>

namespace nt_collisions {

double pull(double stiffness, double stretch) {
    course::require_range(stretch);
    if (!(stiffness > 0 && stiffness <= 1e5)) throw std::invalid_argument{"no such spring"};
    const double strength = stiffness * std::abs(stretch);
    return stretch > 0 ? -strength : strength;
}

} // namespace nt_collisions
