#pragma once
// The game of this chapter, as it grows: eyes, an arm that reaches, apples, motors, a tentacle, and a pen.
#include "inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace inverse_kinematics {

//> The world
constexpr double frame_time = 1.0 / 60;         ///< [s]
constexpr double degree = 0.017453292519943295; ///< [rad]

//> The frame loop: eyes
/// One frame of the game: where each eye looks while there's a fly [rad].
inline std::vector<double> look(const std::vector<Vec2> &eyes, const Vec2 &fly) {
    std::vector<double> angles;
    for (const Vec2 &eye : eyes) angles.push_back(point_at(eye, fly));
    return angles;
}

//> The frame loop: as far as it goes
/// One frame of the game: an arm reaches for a fly, and stays as it is if it doesn't know how.
inline Pose reach_for(const Arm &arm, const Pose &before, const Vec2 &fly) {
    const std::vector<Pose> all = poses(arm, nearest_reachable(arm, fly));
    return all.empty() ? before : all.front();
}

//> Apples
/// Another apple hangs somewhere above the arm, in another place for each number.
inline Apple ripe(unsigned number) {
    const double across = double(number * 2654435761u >> 20) / 4096; // 0 to 1
    return {{-3.8 + 7.6 * across, 4.6}, 0};
}

//> The frame loop: an autumn
/// One frame of the game: yours, and every so often another apple comes loose.
inline void next_frame(Orchard &orchard, unsigned &number, double &until_next, const Vec2 &pointer, double dt) {
    orchard = next_frame(orchard, pointer, dt);
    until_next -= dt;
    if (until_next > 0) return;
    orchard.apples.push_back(ripe(++number));
    until_next += 1.2;
}

//> The frame loop: two motors
/// One frame of the game: both motors turn towards their angles, at 5 rad/s at most. They know nothing of whole turns.
inline void next_frame(Pose &now, const Pose &goal, double dt) {
    now.first += std::clamp(goal.first - now.first, -5 * dt, 5 * dt);
    now.second += std::clamp(goal.second - now.second, -5 * dt, 5 * dt);
}

//> The frame loop: a tentacle
/// One frame of the game: one sweep, from where the tentacle was.
inline void next_frame(const Vec2 &base, std::vector<Link> &tentacle, const Vec2 &fly) {
    tentacle = ccd_sweep(base, tentacle, fly);
}

//> A pen
/// The pose of an arm that draws, at a time [s]; it waits at the end.
inline Pose pen_at(const std::vector<Pose> &poses, double time) {
    return poses[std::min(std::size_t(time * 30), poses.size() - 1)];
}
//>
} // namespace inverse_kinematics
