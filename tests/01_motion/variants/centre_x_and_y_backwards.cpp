// 1.4: two sums, from the last body to the first
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    double total = 0, x = 0, y = 0;
    for (std::size_t i = bodies.size(); i-- > 0;) {
        total += bodies[i].mass;
        x += bodies[i].position.x() * bodies[i].mass;
        y += bodies[i].position.y() * bodies[i].mass;
    }
    if (total > 0) return Vec2{x / total, y / total};
    return std::nullopt;
}

} // namespace motion
