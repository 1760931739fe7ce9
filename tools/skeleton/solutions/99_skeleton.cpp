#include "skeleton.hpp"

namespace skeleton {

//> Solution 99.1: the pull of a spring
double pull(double stiffness, double stretch) {
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    return -stiffness * stretch;
}
//>
} // namespace skeleton
