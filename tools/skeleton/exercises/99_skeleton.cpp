// Section 99, Skeleton. Replace a `throw` by your own code, save, and see:  ./course check 99
// Bad input is refused in one line:
//     course::require(stiffness > 0, "stiffness [N/m] must be positive", stiffness);

#include "skeleton.hpp"

#include <cmath>

namespace skeleton {

// 99.1 core
double pull(double stiffness, double stretch) {
    throw course::NotYet{"which way does a spring pull when you make it longer?"};
}

} // namespace skeleton
