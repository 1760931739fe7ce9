// 1.5: one helper, told at which velocity to move
#include "motion.hpp"

namespace motion {

Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    Integrators after = before;
    const auto moved = [&](const State &state, double fraction) -> State { // of the gained velocity at which it moves
        return {state.position + dt * (state.velocity + fraction * dt * acceleration),
                state.velocity + dt * acceleration};
    };
    after = {moved(before.explicit_euler, 0), moved(before.semi_implicit, 1), moved(before.exact, 0.5)};
    return after;
}

} // namespace motion
