#include "forward_kinematics.hpp"

namespace forward_kinematics {

//> Solution 9.1: the pull of a spring
double pull(double stiffness, double stretch) {
    course::require_range(stiffness, stretch);
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    return -stiffness * stretch;
}
//>
} // namespace forward_kinematics
