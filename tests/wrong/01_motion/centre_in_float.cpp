// 1.4: sums in float
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    float total = 0;
    Eigen::Vector2f weighted = {0, 0};
    for (const PointMass &body : bodies) {
        total += float(body.mass);
        weighted += (body.mass * body.position).cast<float>();
    }
    if (total == 0) return {};
    return (weighted / total).cast<double>();
}

} // namespace motion
