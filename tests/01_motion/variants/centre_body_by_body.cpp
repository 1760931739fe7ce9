// 1.4: each new body pulls the centre towards itself
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    double total = 0;
    Vec2 centre = {0, 0};
    for (const PointMass &body : bodies) {
        if (body.mass == 0) continue;
        total += body.mass;
        centre += body.mass / total * (body.position - centre);
    }
    if (total == 0) return {};
    return centre;
}

} // namespace motion
