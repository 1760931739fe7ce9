#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 8: what balls on a table do to each other.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest number that goes in, or of 1 if that is larger, unless its
/// function says otherwise. Two centres closer together than 1e-60 m may count as the same point, and a relative speed,
/// a radius, a mass or an inverse mass below 1e-20 as 0.
namespace nt_collisions {

using course::Vec2;

//> Normal and tangential components
/// The components of a velocity where two balls, a and b, touch.
struct Components {
    double normal{};     ///< along the line of centres, positive: from a towards b [m/s]
    double tangential{}; ///< at a right angle to it, positive: to the left, as one looks from a to b [m/s]
    COURSE_FIELDS("m/s, m/s", normal, tangential)
};

//> Decompose
/// The normal and the tangential component of a velocity.
/// @param velocity  of whatever moves there, ball a or ball b [m/s]
/// @param a         the centre of ball a [m]
/// @param b         the centre of ball b [m]
/// @throws std::invalid_argument if `a` and `b` are the same point, or a number is not within ±1e5.
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
/// The velocities of two smooth, elastic balls of equal mass after they have met: their normal components change places,
/// and their tangential components stay. Balls that do not approach each other keep their velocities.
/// Only their positions and velocities count: whether they touch is the caller's business.
/// @throws std::invalid_argument if the centres are the same point, if a radius or a mass is not positive, or if a number
///         is not within ±1e5.
Velocities exchange(const Ball &a, const Ball &b);

//> Resolve a collision
/// The velocities of two smooth balls after they have collided. Only their normal components change.
/// Balls that do not approach each other keep their velocities; whether they touch is the caller's business.
/// One digit fewer may be right for each factor of ten by which one mass is larger than the other; with masses below
/// 1e-9 kg any answer may be right to fewer.
/// @param restitution  the normal speed at which they part, divided by that at which they approached [1], from 0 to 1
/// @throws std::invalid_argument if `restitution` is not from 0 to 1, or for what `exchange` refuses.
Velocities resolve_collision(const Ball &a, const Ball &b, double restitution);

//> Time of impact
/// When two balls that keep their velocities first touch, from now on [s]; nothing if they never do.
/// If they touch or overlap now: 0 if their centres are getting closer to each other, never a negative time, and nothing
/// if they are not.
/// At the time of the answer the distance of the centres is the sum of the radii. It is right to nine digits of the
/// largest coordinate, or of the sum of the radii if that is larger; or to six digits, if the largest coordinate is more
/// than a thousand times the sum of the radii. Balls that would pass each other at a distance that is the sum of the
/// radii, as exactly as that, may touch or not.
/// @throws std::invalid_argument if a radius or a mass is not positive, or a number is not within ±1e5.
std::optional<double> time_of_impact(const Ball &a, const Ball &b);

//> A disc that something may hold
/// A ball, or a post that nothing can move.
struct Disc {
    Vec2 position;         ///< of its centre [m]
    double radius{};       ///< [m], more than 0
    double inverse_mass{}; ///< 1 divided by its mass [1/kg], not negative; 0 if nothing can move it
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
/// The centres of two discs that overlap, after they have been moved apart along their line of centres until they just
/// touch. Their centre of mass stays where it is: of two balls, the one with twice the mass moves half as far.
/// Discs that do not overlap stay where they are, and so do two that nothing can move.
/// If the centres are the same point, a moves to the left, and b to the right.
/// @throws std::invalid_argument if a radius is not positive, an inverse mass is negative, or a number is not within ±1e5.
Positions push_apart(const Disc &a, const Disc &b);

//> A pair
/// Two elements of a list, by their indices.
struct Pair {
    int first{};
    int second{}; ///< larger than `first`
    COURSE_FIELDS("1, 1", first, second)
};

//> Close pairs
/// All pairs of points that are no farther apart than `distance`: each pair once, in any order.
/// A pair whose distance differs from `distance` by less than 1e-12 of the largest number that goes in, or of 1 if that
/// is larger, may be among them or not.
/// For a hundred thousand points, none of which has more than ten others within `distance`, it takes 4 s at most.
/// @param centres   [m], any number of them
/// @param distance  [m], 0.001 or more
/// @throws std::invalid_argument if `distance` is less than 0.001, or a number is not within ±1e5.
std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance);

//> The exercises
namespace subject {
COURSE_EXERCISE("8.1", core, nt_collisions, decompose, "velocity [m/s], a [m], b [m]", "")
COURSE_EXERCISE("8.2", core, nt_collisions, exchange, "a, b", "")
COURSE_EXERCISE("8.3", core, nt_collisions, resolve_collision, "a, b, restitution [1]", "")
COURSE_EXERCISE("8.4", stretch, nt_collisions, time_of_impact, "a, b", "s")
COURSE_EXERCISE("8.5", stretch, nt_collisions, push_apart, "a, b", "")
COURSE_EXERCISE("8.6", challenge, nt_collisions, close_pairs, "centres [m], distance [m]", "")
} // namespace subject
//>
} // namespace nt_collisions
