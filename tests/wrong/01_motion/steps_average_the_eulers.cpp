// 1.5: exact is the mean of the two others: true only if all three started together
#include "motion.hpp"

namespace motion {

Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
    for (const State &state : {before.explicit_euler, before.semi_implicit, before.exact})
        course::require_range(state.position, state.velocity);
    course::require_range(acceleration, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Schemes after = before;
    after.explicit_euler.position += dt * before.explicit_euler.velocity;
    after.explicit_euler.velocity += dt * acceleration;
    after.semi_implicit.velocity += dt * acceleration;
    after.semi_implicit.position += dt * after.semi_implicit.velocity;
    after.exact.position = (after.explicit_euler.position + after.semi_implicit.position) / 2;
    after.exact.velocity += dt * acceleration;
    return after;
}

} // namespace motion
