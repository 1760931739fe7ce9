// 1.4: a mass of 0 is refused
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    double total = 0;
    Vec2 weighted = {0, 0};
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass > 0, "mass [kg] must be positive", body.mass);
        total += body.mass;
        weighted += body.mass * body.position;
    }
    if (total == 0) return {};
    return weighted / total;
}

} // namespace motion
