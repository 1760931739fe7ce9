// 1.4: y is the plain mean
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
    double y = 0;
    for (const PointMass &body : bodies) y += body.position.y();
    return Vec2{weighted.x() / total, y / double(bodies.size())};
}

} // namespace motion
