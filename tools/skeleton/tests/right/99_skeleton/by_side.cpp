// 99.1: first how hard, then which way
#include "skeleton.hpp"

#include <cmath>
#include <stdexcept>

namespace skeleton {

double pull(double stiffness, double stretch) {
    if (!(stiffness > 0) || std::isinf(stiffness)) throw std::invalid_argument{"no such spring"};
    const double strength = stiffness * std::abs(stretch);
    if (!std::isfinite(strength)) throw std::invalid_argument{"no such force"};
    return stretch > 0 ? -strength : strength;
}

} // namespace skeleton
