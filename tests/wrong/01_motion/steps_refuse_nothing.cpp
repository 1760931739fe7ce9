// 1.5: nothing is refused
#include "motion.hpp"

namespace motion {

Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
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
