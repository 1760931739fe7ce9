// 9.1: first how hard, then which way
#include "forward_kinematics.hpp"

#include <cmath>
#include <stdexcept>

namespace forward_kinematics {

double pull(double stiffness, double stretch) {
    course::require_range(stretch);
    if (!(stiffness > 0 && stiffness <= 1e5)) throw std::invalid_argument{"no such spring"};
    const double strength = stiffness * std::abs(stretch);
    return stretch > 0 ? -strength : strength;
}

} // namespace forward_kinematics
