// 1.5: one step of each, written out
#include "motion.hpp"

namespace motion {

Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Integrators after = before;
    after.explicit_euler = {before.explicit_euler.position + before.explicit_euler.velocity * dt,
                            before.explicit_euler.velocity + acceleration * dt};
    after.semi_implicit = {before.semi_implicit.position + before.semi_implicit.velocity * dt + acceleration * dt * dt,
                           before.semi_implicit.velocity + acceleration * dt};
    after.exact = {before.exact.position + before.exact.velocity * dt + 0.5 * acceleration * dt * dt,
                   before.exact.velocity + acceleration * dt};
    return after;
}

} // namespace motion
