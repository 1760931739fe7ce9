// 1.4: masses in whole kilograms: int
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    int total = 0;
    Vec2 weighted = {0, 0};
    for (const PointMass &body : bodies) {
        total += int(body.mass);
        weighted += int(body.mass) * body.position;
    }
    if (total == 0) return {};
    return weighted / total;
}

} // namespace motion
