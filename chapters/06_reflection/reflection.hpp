#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 6: what a wall does to a velocity.
/// Numbers that go in are within ±1e5, both ends included; an answer may be larger. Twelve digits must
/// be right; where fewer will do, the tests say. A vector shorter than 1e-60 may count as 0.
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
/// The four sides of a table or a screen, parallel to the axes.
struct Box {
    Vec2 low;  ///< its corner at the lower left [m]
    Vec2 high; ///< its corner at the upper right [m]
    COURSE_FIELDS("m, m", low, high)
};

//> Bounce in a box
/// A ball's velocity after it has met the sides of its box [m/s]. Once the ball's edge is past a side, the component that
/// leads out through that side is reversed; a ball that's already coming back is left alone. When the edge only just
/// touches a side, either is right.
/// @throws std::invalid_argument if the radius is negative, or the box is not wider and higher than the ball.
Vec2 bounce_in_box(const Ball &ball, const Box &box);

//> Reflect
/// A ball's velocity after it has hit a smooth wall [m/s]: its normal part is reversed, and its tangential part stays.
/// @param velocity  before [m/s]
/// @param normal    at a right angle to the wall, on either side of it, and of any length but 0
/// @throws std::invalid_argument if `normal` is zero.
Vec2 reflect(const Vec2 &velocity, const Vec2 &normal);

//> Unit normal
/// The vector of length 1 at a right angle to a wall, pointing to your left when you walk from `start` to `end`. Nearer to
/// each other than 1e-60 m, these may count as the same point.
/// @param start  where the wall starts [m]
/// @param end    where it ends [m]
/// @throws std::invalid_argument if `start` and `end` are the same point.
Vec2 unit_normal(const Vec2 &start, const Vec2 &end);

//> A surface
/// What a wall is made of.
struct Surface {
    double restitution{}; ///< how much of the normal speed comes back [1], not negative; above 1, it kicks
    double mu_k{};        ///< coefficient of kinetic friction [1], not negative
    COURSE_FIELDS("1, 1", restitution, mu_k)
};

//> Bounce off a surface
/// A ball's velocity after it has hit a wall [m/s]; the ball doesn't spin. Its normal part is reversed, and `restitution`
/// times as fast as before. Its tangential part loses mu_k times the change of the normal part, and never more than there
/// is. A ball that isn't moving towards the wall keeps its velocity.
/// @param velocity  before [m/s]
/// @param normal    at a right angle to the wall, on the ball's side of it, and of any length but 0
/// @throws std::invalid_argument if `normal` is zero, or `restitution` or `mu_k` is negative.
Vec2 bounce(const Vec2 &velocity, const Vec2 &normal, const Surface &surface);

//> Bounce in a rotated box
/// A ball's velocity after it has met the sides of a box that's been turned about the origin, anticlockwise [m/s]: seen
/// from the box, that's what `bounce_in_box` does.
/// @param box    as it was before you turned it
/// @param angle  [rad], negative: clockwise
/// @throws std::invalid_argument for what `bounce_in_box` refuses.
Vec2 bounce_in_rotated_box(const Ball &ball, const Box &box, double angle);

//> A bank shot
/// What direction to push a ball in, so that its centre gets to `target` off the cushions, without friction: a vector of
/// length 1 that points from the ball to a mirror image of the target. The ball's velocity doesn't matter.
/// @param target  where the ball's centre should get to [m]
/// @param across  how many tables the image is to the right (negative: to the left), from -100 to 100
/// @param up      how many tables it's up (negative: down), from -100 to 100
/// @throws std::invalid_argument if the ball's centre or `target` is closer to a side than the radius by more than
///         rounding, the ball is at the image already, `across` or `up` is out of range, or for what `bounce_in_box`
///         refuses.
Vec2 bank_shot(const Ball &ball, const Vec2 &target, const Box &table, int across, int up);

//> A bumper
/// Something on a pinball table: a straight strip with round ends. If both ends are the same point, it's round.
struct Bumper {
    Vec2 start;       ///< of its middle line [m]
    Vec2 end;         ///< of its middle line [m]
    double radius{};  ///< from its middle line to its edge [m], not negative
    Surface surface;  ///< of its edge
    double turning{}; ///< how fast it turns about `start`, anticlockwise [rad/s]: a flipper, on its way
    int points{};     ///< what a hit is worth
    bool touched{};   ///< whether the ball touched it in the last frame
    COURSE_FIELDS("m, m, m, , rad/s, 1, ", start, end, radius, surface, turning, points, touched)
};

//> A game of pinball
/// A table seen from above: its lower end is at y = 0.
struct Pinball {
    Ball ball;
    std::vector<Bumper> bumpers;
    int score{};
    bool over{}; ///< whether the ball is lost
    COURSE_FIELDS(", , 1, ", ball, bumpers, score, over)
};

//> Play pinball
/// The game after a frame. First the ball's velocity changes, then it moves at its new velocity. Then each bumper has its
/// turn, in the order of the list: if the ball's edge is past its edge, the ball touches it. It's set back, straight away
/// from the nearest point of the middle line, to where their edges only just touch; and it leaves as `bounce` says, seen
/// from the edge of the bumper, which moves if the bumper turns. A touch scores, unless the ball touched that bumper in the
/// last frame, too. `touched` then tells of this frame. In the end, a ball whose centre is below y = 0 is lost, and a game
/// that's over stays as it is. When edges only just touch, either is right.
/// The bumpers turn too little in a frame to be seen: their places stay. The ball's centre never gets to a middle line.
/// @param pull  how much faster the ball gets each second, down the table or by a nudge [m/s²]
/// @param dt    [s], not negative
/// @throws std::invalid_argument if a radius or `dt` is negative, or for a surface that `bounce` refuses.
Pinball play_pinball(Pinball now, const Vec2 &pull, double dt);

//>
namespace subject {
COURSE_EXERCISE("6.1", core, reflection, bounce_in_box, "ball, box", "m/s")
COURSE_EXERCISE("6.2", core, reflection, reflect, "velocity [m/s], normal [1]", "m/s")
COURSE_EXERCISE("6.3", core, reflection, unit_normal, "start [m], end [m]", "1")
COURSE_EXERCISE("6.4", stretch, reflection, bounce, "velocity [m/s], normal [1], surface", "m/s")
COURSE_EXERCISE("6.5", stretch, reflection, bounce_in_rotated_box, "ball, box, angle [rad]", "m/s")
COURSE_EXERCISE("6.6", challenge, reflection, bank_shot, "ball, target [m], table, across [1], up [1]", "1")
COURSE_EXERCISE("6.7", challenge, reflection, play_pinball, "now, pull [m/s²], dt [s]", "")
} // namespace subject
} // namespace reflection
