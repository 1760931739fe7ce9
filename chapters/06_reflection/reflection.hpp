#pragma once
#include "../course.hpp"
#include "../interface.hpp"

/// Section 6: what a wall does to a velocity.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest number that goes in, or of 1 if that is larger, unless its
/// function says otherwise. A wall or a normal shorter than 1e-60 may count as one of length 0.
namespace reflection {

using course::Vec2;

//> A ball, and a box
/// A ball on a table, seen from above.
struct Ball {
    Vec2 position;   ///< of its centre [m]
    Vec2 velocity;   ///< [m/s]
    double radius{}; ///< [m], not negative
    COURSE_FIELDS("m, m/s, m", position, velocity, radius)
};
/// The four sides of a table, or of a screen. They are parallel to the axes.
struct Box {
    Vec2 low;  ///< its corner at the lower left [m]
    Vec2 high; ///< its corner at the upper right [m]
    COURSE_FIELDS("m, m", low, high)
};

//> Bounce in a box
/// The velocity of a ball in a box, after it has met the sides [m/s].
/// A side that the ball's edge has passed reverses the component of the velocity that leads out through this side; a
/// ball that already moves away from a side is not turned by it. Where the edge just touches a side, up to rounding,
/// either is right.
/// @throws std::invalid_argument if the radius is negative, if the box is not wider and higher than the ball, or if a
///         number is not within ±1e5.
Vec2 bounce_in_box(const Ball &ball, const Box &box);

//> Reflect
/// The velocity of a ball that has hit a smooth wall [m/s]: its normal part is reversed, its tangential part stays.
/// @param velocity  before [m/s]
/// @param normal    at a right angle to the wall, to either side, and of any length but 0
/// @throws std::invalid_argument if `normal` is zero, or a number is not within ±1e5.
Vec2 reflect(const Vec2 &velocity, const Vec2 &normal);

//> Unit normal
/// The vector of length 1 at a right angle to a wall, to the left as one walks from `start` to `end`.
/// @param start  where the wall begins [m]
/// @param end    where it ends [m]
/// @throws std::invalid_argument if `start` and `end` are the same point, or a number is not within ±1e5.
Vec2 unit_normal(const Vec2 &start, const Vec2 &end);

//> A surface
/// What a wall is made of.
struct Surface {
    double restitution{}; ///< how much of the normal speed comes back [1], from 0 to 1
    double mu_k{};        ///< coefficient of kinetic friction [1], not negative
    COURSE_FIELDS("1, 1", restitution, mu_k)
};

//> Bounce off a surface
/// The velocity of a ball, which does not spin, after it has hit a wall [m/s].
/// Its normal part is reversed, and `restitution` times as fast as before. The tangential part loses mu_k times the
/// change of the normal part, but never more than there is. A ball that does not approach the wall keeps its velocity.
/// @param velocity  before [m/s]
/// @param normal    at a right angle to the wall, to the side of the ball, and of any length but 0
/// @throws std::invalid_argument if `normal` is zero, `restitution` is not from 0 to 1, `mu_k` is negative, or a number
///         is not within ±1e5.
Vec2 bounce(const Vec2 &velocity, const Vec2 &normal, const Surface &surface);

//> Bounce in a rotated box
/// What `bounce_in_box` says if the box has been turned about the origin, anticlockwise.
/// A position or a velocity with a component beyond ±1e5, as seen from the box, may be refused.
/// @param box    as it was before it was turned
/// @param angle  [rad], negative: clockwise
/// @throws std::invalid_argument for what `bounce_in_box` refuses, or if `angle` is not within ±1e5.
Vec2 bounce_in_rotated_box(const Ball &ball, const Box &box, double angle);

//> A bank shot
/// The direction in which to push a ball so that its centre gets to `target` by way of the cushions, without friction:
/// a vector of length 1 that points from the ball to a mirror image of the target. The velocity of `ball` is of no
/// account. If the image is d metres away, and d is less than 1, the error may be 1/d times as large.
/// @param target  where the centre is to get [m]
/// @param across  how many tables the image is to the right, negative: to the left, from -100 to 100
/// @param up      how many tables it is up, negative: down, from -100 to 100
/// @throws std::invalid_argument if the ball is, or would be at `target`, less than its radius from a side; if it is at
///         the image already; if `across` or `up` is out of its range; or for what `bounce_in_box` refuses.
Vec2 bank_shot(const Ball &ball, const Vec2 &target, const Box &table, int across, int up);

//> The exercises
namespace subject {
COURSE_EXERCISE("6.1", core, reflection, bounce_in_box, "ball, box", "m/s")
COURSE_EXERCISE("6.2", core, reflection, reflect, "velocity [m/s], normal [1]", "m/s")
COURSE_EXERCISE("6.3", core, reflection, unit_normal, "start [m], end [m]", "1")
COURSE_EXERCISE("6.4", stretch, reflection, bounce, "velocity [m/s], normal [1], surface", "m/s")
COURSE_EXERCISE("6.5", stretch, reflection, bounce_in_rotated_box, "ball, box, angle [rad]", "m/s")
COURSE_EXERCISE("6.6", challenge, reflection, bank_shot, "ball, target [m], table, across [1], up [1]", "1")
} // namespace subject
//>
} // namespace reflection
