// Section 8, n–t collisions. Replace a `throw` by your own code, save, and see:  ./course check 8
// The lines that refuse bad input are written for you.

#include "nt_collisions.hpp"

namespace nt_collisions {

// 8.1 core
double pull(double stiffness, double stretch) {
    course::require_range(stiffness, stretch);
    course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);
    throw course::NotYet{"which way does a spring pull when you make it longer?"};
}

} // namespace nt_collisions
