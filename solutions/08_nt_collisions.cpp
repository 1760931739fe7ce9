#include "nt_collisions.hpp"

namespace nt_collisions {

//> Solution 8.1: the pull of a spring
double pull(double stiffness, double stretch) {
    course::require_range(stiffness, stretch);
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    return -stiffness * stretch;
}
//>
} // namespace nt_collisions
