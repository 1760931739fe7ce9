// 1.4: where the heaviest is
#include "motion.hpp"

namespace motion {

std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    for (const PointMass &body : bodies) {
        course::require_range(body.position, body.mass);
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
    }
    const PointMass *heaviest = nullptr;
    for (const PointMass &body : bodies)
        if (body.mass > (heaviest == nullptr ? 0 : heaviest->mass)) heaviest = &body;
    if (heaviest == nullptr) return {};
    return heaviest->position;
}

} // namespace motion
