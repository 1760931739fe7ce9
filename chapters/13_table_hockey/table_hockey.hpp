#pragma once
#include "../01_motion/motion.hpp"
#include "../02_momentum/momentum.hpp"
#include "../03_gravity_wells/gravity_wells.hpp"
#include "../04_trajectories/trajectories.hpp"
#include "../05_inclined_planes/inclined_planes.hpp"
#include "../06_reflection/reflection.hpp"
#include "../07_segment_intersection/segment_intersection.hpp"
#include "../08_nt_collisions/nt_collisions.hpp"
#include "../09_forward_kinematics/forward_kinematics.hpp"
#include "../10_inverse_kinematics/inverse_kinematics.hpp"
#include "../11_particles/particles.hpp"
#include "../12_time_based_motion/time_based_motion.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 13: a game of table hockey, seen from above, in which all of this course runs.
/// Numbers that go in are within ±1e5. How exact a game has to be, the tests say.
namespace table_hockey {

using course::Vec2;
using inverse_kinematics::Arm;  ///< `first`, `second`: lengths [m]
using inverse_kinematics::Pose; ///< `first`, `second`: angles, each as in a Link [rad]
using particles::Particle;      ///< `position` [m], `velocity` [m/s], `age` [s], `life` [s]
using segment_intersection::Segment;

//> The table
constexpr double half_length = 1, half_width = 0.5, half_goal = 0.15; ///< the middle is at (0, 0) [m]
constexpr double disc_radius = 0.03, mallet_radius = 0.05;            ///< [m]
constexpr double disc_mass = 0.05;                                    ///< [kg]; nothing moves a mallet but its arm
constexpr double felt = 0.1;                                          ///< how much speed the disc loses [m/s²]
constexpr reflection::Surface cushion{0.9, 0.05};                     ///< what cushions are made of
constexpr double mallet_restitution = 0.8;                            ///< of the disc and a mallet [1]
constexpr double well_strength = 0.1, well_softening = 0.2;           ///< mu [m³/s²] and epsilon [m] of the well
constexpr double step_time = 1.0 / 240;                               ///< [s]

/// The six cushions, from corner to goal post and from corner to corner. The gaps between them are the goals.
inline std::vector<Segment> cushions() {
    const double x = half_length, y = half_width, goal = half_goal;
    return {{{-x, -y}, {x, -y}},   {{-x, y}, {x, y}},     {{-x, -y}, {-x, -goal}},
            {{-x, goal}, {-x, y}}, {{x, -y}, {x, -goal}}, {{x, goal}, {x, y}}};
}

//> A disc and a player
struct Disc {
    Vec2 place{0, 0};    ///< [m]
    Vec2 velocity{0, 0}; ///< [m/s]
    COURSE_FIELDS("m, m/s", place, velocity)
};
/// A player has an arm with a mallet in its hand. The arm is bolted to the floor behind the player's own goal.
struct Player {
    int side = -1;       ///< -1: plays on the left, 1: on the right
    Pose pose;           ///< of the arm; on the right, as in a mirror
    Vec2 mallet{0, 0};   ///< where it is [m]
    Vec2 velocity{0, 0}; ///< of the mallet [m/s]
    int goals = 0;
    COURSE_FIELDS("1, , m, m/s, 1", side, pose, mallet, velocity, goals)
};
constexpr Arm arm{0.7, 0.7};         ///< [m]
constexpr double shoulder = -1.2;    ///< where the left one is bolted: x [m], at y = 0
constexpr double mallet_speed = 2.5; ///< the most that a mallet does [m/s]

//> A world
constexpr double serve_time = 1; ///< [s]
struct World {
    Disc disc;
    Player left, right{1, {}, {0, 0}, {0, 0}, 0};
    std::vector<Particle> sparks; ///< places are measured from the corner (-half_length, -half_width) [m]
    int serve_to = 1;             ///< the side of the player who gets the next serve
    double wait = serve_time;     ///< until a disc that rests on the centre line is served [s]
    double spare = 0;             ///< time that no step has used yet [s]
    COURSE_FIELDS(", , , , 1, s, s", disc, left, right, sparks, serve_to, wait, spare)
};

//> Inputs
struct Inputs {
    Vec2 left{-half_length / 2, 0}, right{half_length / 2, 0}; ///< where each player wants the mallet [m]
    bool well = false;                                         ///< whether the well in the middle is on
    COURSE_FIELDS("m, m, ", left, right, well)
};

//> A mirror
/// A place, as the left player would see it; and back again.
inline Vec2 seen_from(int side, const Vec2 &place) { return {-side * place.x(), place.y()}; }

//> Its own half
constexpr double touch = disc_radius + mallet_radius; ///< from disc to mallet, when they touch [m]
/// The nearest place that the left player's mallet can get to [m]: it touches a disc on the centre line, and no more.
inline Vec2 in_own_half(const Vec2 &place) {
    const Vec2 low{mallet_radius - half_length, mallet_radius - half_width}, high{-touch, -low.y()};
    return place.cwiseMax(low).cwiseMin(high);
}

//> Follow the hand
/// The player one step of `step_time` later. The mallet goes straight to the wanted place, no faster than `mallet_speed`,
/// and stays in its own half of the table. It knows nothing of the disc.
inline Player follow_hand(Player now, const Vec2 &wanted) {
    const Vec2 from = seen_from(now.side, now.mallet), goal = in_own_half(seen_from(now.side, wanted));
    const Vec2 way = goal - from, base{shoulder, 0};
    const double most = mallet_speed * step_time, far = way.norm();
    const Vec2 next = far > most ? Vec2{from + most / far * way} : goal;
    now.pose = inverse_kinematics::continued(arm, now.pose, next - base);
    const Vec2 hand = forward_kinematics::two_links({arm.first, now.pose.first}, {arm.second, now.pose.second}).hand;
    now.velocity = seen_from(now.side, base + hand - from) / step_time;
    now.mallet = seen_from(now.side, base + hand);
    return now;
}

//> A serve
constexpr double serve_speed = 0.8;  ///< [m/s]
constexpr double centre_line = 0.01; ///< a disc is on the centre line if it's no farther from x = 0 than this [m]

/// How the disc starts: to the player who gets the serve, at another angle after each goal [m/s].
inline Vec2 serve_velocity(const World &now) {
    constexpr double angles[]{35, -20, 50, -40, 15, -55}; // of a serve to the right [°]
    const double angle = angles[(now.left.goals + now.right.goals) % 6];
    return seen_from(-now.serve_to, trajectories::launch_velocity(serve_speed, angle));
}

//> Sparks
constexpr double hard = 0.5; ///< a hit or a bounce is hard if it changes the velocity by this, or more [m/s]
constexpr int sparks_a_hit = 8, most_sparks = 64;
constexpr double spark_speed = 0.6, spark_life = 0.4; ///< [m/s], [s]

/// The sparks one step later, with a ring of new ones round the disc if the step was a hard one for it.
inline std::vector<Particle> next_sparks(const std::vector<Particle> &sparks, const Disc &before, const Disc &after) {
    const Vec2 corner{-half_length, -half_width};
    std::vector<Particle> newborn, flying;
    if ((after.velocity - before.velocity).norm() >= hard)
        for (const Vec2 &each : particles::ring_burst(sparks_a_hit, spark_speed, 0))
            newborn.push_back({after.place - corner, each, 0, spark_life});
    for (const Particle &each : sparks)
        if (const auto later = particles::step(each, {0, 0, 2 * half_length, 2 * half_width}, step_time))
            flying.push_back(*later);
    return particles::compact_pool(flying, newborn, most_sparks);
}

//> Step
/// The world dt later. Time is used up in steps of `step_time`, and what's less than a step waits in `spare`. In each step:
/// - One after the other, in either order, the mallets follow their hands. A mallet hits a disc in its way and pushes it
///   aside; without room for that, the mallet stops.
/// - The well pulls, if it's on, and the felt slows the disc down. Then the disc moves. It bounces off cushions, goal posts
///   and mallets, each with its restitution, and passes through none.
/// - Sparks fly, as in `next_sparks`, which compares the disc with what it was before the step.
/// - When the disc's centre is beyond a goal line, it's a goal for the player at the other end. The disc goes back to the
///   middle, at rest, and the player who let it in gets the serve.
/// - A disc that rested on the centre line for `serve_time` is served, with `serve_velocity`. Moving restarts the wait.
/// @param dt  [s], 0 to 0.25
/// @throws std::invalid_argument if dt isn't from 0 to 0.25, if `spare` isn't from 0 to `step_time`, if a player is on
///         the wrong side or has fewer than 0 goals, if `serve_to` isn't -1 or 1, if there are too many sparks, or
///         one that section 11 refuses.
World step(World now, const Inputs &inputs, double dt);

//> Opening
/// The world before the first serve: both mallets in front of their goals.
inline World opening() {
    World now;
    now.left.mallet = {-half_length / 2, 0};
    now.right.mallet = {half_length / 2, 0};
    now.left.pose = now.right.pose = inverse_kinematics::poses(arm, now.left.mallet - Vec2{shoulder, 0}).front();
    return now;
}

//>
namespace subject {
COURSE_EXERCISE("13.1", challenge, table_hockey, step, "now, inputs, dt [s]", "")
} // namespace subject
} // namespace table_hockey
