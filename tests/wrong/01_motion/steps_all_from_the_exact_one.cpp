// 1.5: each starts from the exact state
#include "motion.hpp"

namespace motion {

Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
    for (const State &state : {before.explicit_euler, before.semi_implicit, before.exact})
        course::require_range(state.position, state.velocity);
    course::require_range(acceleration, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Schemes all{before.exact, before.exact, before.exact};
    Schemes after = before;
    after = all;
    after.explicit_euler.position += dt * all.explicit_euler.velocity;
    after.explicit_euler.velocity += dt * acceleration;
    after.semi_implicit.velocity += dt * acceleration;
    after.semi_implicit.position += dt * after.semi_implicit.velocity;
    after.exact.position += dt * before.exact.velocity + dt * dt / 2 * acceleration;
    after.exact.velocity += dt * acceleration;
    return after;
}

} // namespace motion
