// 1.4: the middle of the box round them
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    Vec2 low = {1e5, 1e5}, high = {-1e5, -1e5};
    double total = 0;
    for (const PointMass &body : bodies) {
        low = low.cwiseMin(body.position);
        high = high.cwiseMax(body.position);
        total += body.mass;
    }
    if (total == 0) return {};
    return (low + high) / 2;
}

} // namespace motion
