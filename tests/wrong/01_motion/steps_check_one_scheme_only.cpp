// 1.5: only the exact state is checked
#include "motion.hpp"

namespace motion {

Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
    course::require_range(before.exact.position, before.exact.velocity, acceleration, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Schemes after = before;
    after.explicit_euler.position += dt * before.explicit_euler.velocity;
    after.explicit_euler.velocity += dt * acceleration;
    after.semi_implicit.velocity += dt * acceleration;
    after.semi_implicit.position += dt * after.semi_implicit.velocity;
    after.exact.position += dt * before.exact.velocity + dt * dt / 2 * acceleration;
    after.exact.velocity += dt * acceleration;
    return after;
}

} // namespace motion
