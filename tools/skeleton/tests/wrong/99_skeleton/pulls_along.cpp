// 99.1: the minus sign is forgotten, so the spring pulls where it is pulled
#include "skeleton.hpp"

#include <cmath>

namespace skeleton {

double pull(double stiffness, double stretch) {
    const double force = stiffness * stretch;
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    course::require(std::isfinite(stiffness) && std::isfinite(force), "force [N] must be finite", force);
    return force;
}

} // namespace skeleton
