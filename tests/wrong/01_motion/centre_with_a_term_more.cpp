// 1.4: from i = 0 to n: the last body counts twice
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    double total = 0;
    Vec2 weighted = {0, 0};
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
        total += body.mass;
        weighted += body.mass * body.position;
    }
    if (total == 0) return {};
    return (weighted + bodies.back().mass * bodies.back().position) / (total + bodies.back().mass);
}

} // namespace motion
