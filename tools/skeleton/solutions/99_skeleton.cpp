#include "skeleton.hpp"

#include <cmath>

namespace skeleton {

//> Solution 99.1: the pull of a spring
double pull(double stiffness, double stretch) {
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    const double force = -stiffness * stretch; // against the stretch: it pulls back, or pushes back
    course::require(std::isfinite(stiffness) && std::isfinite(force), "force [N] must be finite", force);
    return force;
}
//>
} // namespace skeleton
