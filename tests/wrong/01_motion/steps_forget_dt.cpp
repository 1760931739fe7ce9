// 1.5: per frame: dt is taken for 1
#include "motion.hpp"

namespace motion {

Schemes step(const Schemes &before, const Vec2 &acceleration, double dt) {
    for (const State &state : {before.explicit_euler, before.semi_implicit, before.exact})
        course::require_range(state.position, state.velocity);
    course::require_range(acceleration, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Schemes after = before;
    after.explicit_euler.position += before.explicit_euler.velocity;
    after.explicit_euler.velocity += acceleration;
    after.semi_implicit.velocity += acceleration;
    after.semi_implicit.position += after.semi_implicit.velocity;
    after.exact.position += before.exact.velocity + acceleration / 2;
    after.exact.velocity += acceleration;
    return after;
}

} // namespace motion
