// 1.4: one negative mass passes if the others weigh more
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    double total = 0;
    Vec2 weighted = {0, 0};
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        total += body.mass;
        weighted += body.mass * body.position;
    }
    course::require(total >= 0, "mass [kg] must not be negative", total);
    if (total == 0) return {};
    return weighted / total;
}

} // namespace motion
