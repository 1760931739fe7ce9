// 1.4: the mean of the positions
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    Vec2 sum = {0, 0};
    double total = 0;
    for (const PointMass &body : bodies) {
        sum += body.position;
        total += body.mass;
    }
    if (total == 0) return {};
    return sum / double(bodies.size());
}

} // namespace motion
