#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 8: what balls on a table do to each other. Numbers that go in are within ±1e5; an answer may be larger.
/// Twelve digits must be right; where fewer will do, the tests say. Points nearer to each other than 1e-60 m may count
/// as the same one.
namespace nt_collisions {

using course::Vec2;

//> Normal and tangential components
/// The components of a velocity where two balls, a and b, touch.
struct Components {
    double normal{};     ///< along the line of centres, positive: from a towards b [m/s]
    double tangential{}; ///< across it, positive: to the left, as you look from a to b [m/s]
    COURSE_FIELDS("m/s, m/s", normal, tangential)
};

//> Decompose
/// How much of a velocity is along the line of centres of two balls, and how much is across it.
/// @param velocity  of ball a, or of ball b [m/s]
/// @param a         the centre of ball a [m]
/// @param b         the centre of ball b [m]
/// @throws std::invalid_argument if `a` and `b` are the same point.
Components decompose(const Vec2 &velocity, const Vec2 &a, const Vec2 &b);

//> A ball with a mass
/// A ball on a table, seen from above.
struct Ball {
    Vec2 position;   ///< of its centre [m]
    Vec2 velocity;   ///< [m/s]
    double radius{}; ///< [m], more than 0
    double mass{};   ///< [kg], more than 0
    COURSE_FIELDS("m, m/s, m, kg", position, velocity, radius, mass)
};

//> Two velocities
/// The velocities of two balls.
struct Velocities {
    Vec2 a; ///< [m/s]
    Vec2 b; ///< [m/s]
    COURSE_FIELDS("m/s, m/s", a, b)
};

//> Exchange
/// The velocities of two smooth, elastic balls of equal mass after a collision: they swap their normal components, and
/// keep their tangential ones. Balls that don't approach each other keep their velocities.
/// Only positions and velocities count: you call this when the balls touch. Whether they do is up to rounding: at 0, 0.6,
/// 1.2 m and so on, 39 of the first 99 neighbours of 0.3 m have centres no farther apart than both radii. When both
/// centres are the same point, call `push_apart` first.
/// @throws std::invalid_argument if the centres are the same point, or a radius or a mass is not positive.
Velocities exchange(const Ball &a, const Ball &b);

//> Resolve a collision
/// The velocities of two smooth balls after a collision, which changes only their normal components.
/// Balls that don't approach each other keep their velocities. You call this when the balls touch.
/// @param restitution  how fast they part along the line of centres, divided by how fast they approached along it [1],
///                     from 0 to 1
/// @throws std::invalid_argument if `restitution` is not from 0 to 1, or for what `exchange` refuses.
Velocities resolve_collision(const Ball &a, const Ball &b, double restitution);

//> Time of impact
/// When two balls that keep their velocities first touch, from now on [s]; nothing if they never do.
/// When they touch or overlap already: 0 if their centres are getting closer, and nothing if they aren't. The answer is
/// never negative.
/// @throws std::invalid_argument if a radius or a mass is not positive.
std::optional<double> time_of_impact(const Ball &a, const Ball &b);

//> A disc that something may hold
/// A ball, or a post that nothing can move.
struct Disc {
    Vec2 position;         ///< of its centre [m]
    double radius{};       ///< [m], more than 0
    double inverse_mass{}; ///< 1 divided by its mass [1/kg], not negative; 0 when nothing can move it
    COURSE_FIELDS("m, m, 1/kg", position, radius, inverse_mass)
};

//> Two positions
/// The centres of two discs.
struct Positions {
    Vec2 a; ///< [m]
    Vec2 b; ///< [m]
    COURSE_FIELDS("m, m", a, b)
};

//> Push apart
/// The centres of two discs that overlapped, now apart along their line of centres, so that they just touch. Their
/// centre of mass stays where it is: with twice the mass, a disc moves half as far.
/// Discs that don't overlap stay where they are, and so do two that nothing can move.
/// When both centres are the same point, a moves to the left, and b to the right.
/// @throws std::invalid_argument if a radius is not positive, or an inverse mass is negative.
Positions push_apart(const Disc &a, const Disc &b);

//> A pair
/// Two elements of a list, by their indices.
struct Pair {
    int first{};
    int second{}; ///< larger than `first`
    COURSE_FIELDS("1, 1", first, second)
};

//> Close pairs
/// All pairs of points no farther apart than `distance`: each pair once, in any order. A pair that's just as far apart,
/// up to rounding, may be among them or not.
/// It takes 4 s at most for a hundred thousand points, none of which has more than ten others within `distance`.
/// @param centres   [m], any number of them
/// @param distance  [m], 0.001 or more
/// @throws std::invalid_argument if `distance` is less than 0.001.
std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance);

//>
namespace subject {
COURSE_EXERCISE("8.1", core, nt_collisions, decompose, "velocity [m/s], a [m], b [m]", "")
COURSE_EXERCISE("8.2", core, nt_collisions, exchange, "a, b", "")
COURSE_EXERCISE("8.3", core, nt_collisions, resolve_collision, "a, b, restitution [1]", "")
COURSE_EXERCISE("8.4", stretch, nt_collisions, time_of_impact, "a, b", "s")
COURSE_EXERCISE("8.5", stretch, nt_collisions, push_apart, "a, b", "")
COURSE_EXERCISE("8.6", challenge, nt_collisions, close_pairs, "centres [m], distance [m]", "")
} // namespace subject
} // namespace nt_collisions
