// 1.4: first the total, then each position times its fraction of it
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    double total = 0;
    for (const PointMass &body : bodies) total += body.mass;
    if (total == 0) return {};
    Vec2 centre = {0, 0};
    for (const PointMass &body : bodies) centre += body.mass / total * body.position;
    return centre;
}

} // namespace motion
