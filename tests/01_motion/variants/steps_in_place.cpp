// 1.5: in place: only the order of two lines differs
#include "motion.hpp"

namespace motion {

Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Integrators after = before;
    after.explicit_euler.position += dt * before.explicit_euler.velocity;
    after.explicit_euler.velocity += dt * acceleration;
    after.semi_implicit.velocity += dt * acceleration;
    after.semi_implicit.position += dt * after.semi_implicit.velocity;
    after.exact.velocity += dt * acceleration / 2; // half of it before the move, half after it
    after.exact.position += dt * after.exact.velocity;
    after.exact.velocity += dt * acceleration / 2;
    return after;
}

} // namespace motion
