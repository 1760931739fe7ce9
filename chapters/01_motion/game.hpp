#pragma once
// What flies in this section's game, and how one frame leads to the next.

#include "motion.hpp"

namespace motion {

//> The frame loop: a helicopter
/// A helicopter on the screen.
struct Helicopter {
    Vec2 position{20, 80};                  ///< [px]
    Vec2 velocity{px_per_second(4, 30), 0}; ///< [px/s]: 4 px per frame, at 30 frames per second
};

/// One frame of the game: the helicopter moves for `dt` seconds.
inline void next_frame(Helicopter &helicopter, double dt) {
    helicopter.position = uniform_motion(helicopter.position, helicopter.velocity, dt);
}

//> The frame loop: a missile
/// A missile: where it is and how it moves, and what accelerates it.
struct Missile {
    State state;
    Vec2 acceleration; ///< of its engine, or of gravity
    double mass = 1;   ///< [kg]
};

/// One frame of the game: the missile moves for `dt` seconds.
inline void next_frame(Missile &missile, double dt) {
    missile.state = accelerated_motion(missile.state, missile.acceleration, dt);
}

//> The frame loop: what the camera looks at
/// The point that a camera follows: the centre of mass of all pieces, or nothing.
inline std::optional<Vec2> camera_target(const std::vector<Missile> &pieces) {
    std::vector<PointMass> bodies;
    for (const Missile &piece : pieces) bodies.push_back({piece.state.position, piece.mass});
    return centre_of_mass(bodies);
}
//>
} // namespace motion
