// One that never ends.
#include "forward_kinematics.hpp"

double of_the_same_name(double x) { return 2 * x; }

namespace forward_kinematics {

std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links) {
    double left = of_the_same_name(1);
    while (left > 0) left += double(links.size());
    return {base};
}

} // namespace forward_kinematics
