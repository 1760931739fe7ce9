#pragma once
#include "../09_forward_kinematics/forward_kinematics.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 10: which angles bring a hand to a place.
/// Angles are in radians and go anticlockwise. Numbers that go in are within ±1e5. Nine digits must be right,
/// and a hand is where it has to be to 1e-12 of the arm's length; where less will do, the tests say.
namespace inverse_kinematics {

using course::Vec2;
using forward_kinematics::Link; ///< `length` [m], `angle`: how far it bends away from the link before it [rad]
using forward_kinematics::Pose; ///< `first`, `second`: the angles of both links, each as in a Link [rad]

//> Point at
/// The angle at which a link points from its joint to the target [rad], from -π to π; 0 when both are the same point.
double point_at(const Vec2 &joint, const Vec2 &target);

//> An arm
/// An arm with two links. Its first joint is at the origin.
struct Arm {
    double first{}, second{}; ///< lengths of its links, more than 0 [m]
    COURSE_FIELDS("m, m", first, second)
};

//> Poses
/// All poses that bring the hand to the target: two, first the one whose elbow bends left, so its second angle is positive;
/// one when the arm has to be straight or folded; none when the target is out of reach. First angles are from -π to π, and
/// so are second ones. Up to 1e-12 of both lengths together beyond the reach still counts as on its border.
/// When both links are equally long and the target is at the first joint, every first angle will do: answer {0, π}.
/// @throws std::invalid_argument if a length is not positive.
std::vector<Pose> poses(const Arm &arm, const Vec2 &target);

//> Nearest reachable
/// The point nearest to the target that the hand can reach [m]. From the first joint itself, when that's too near, all
/// directions are the same: go to the right, along the x axis.
/// @throws std::invalid_argument if a length is not positive.
Vec2 nearest_reachable(const Arm &arm, const Vec2 &target);

//> An orchard
/// An apple that falls.
struct Apple {
    Vec2 place;     ///< [m]
    double speed{}; ///< downwards [m/s]
    COURSE_FIELDS("m, m/s", place, speed)
};
/// An arm among apple trees.
struct Orchard {
    Pose pose;                 ///< of the arm
    std::vector<Apple> apples; ///< in the air
    int caught{}, missed{};    ///< how many, so far
    COURSE_FIELDS(", , 1, 1", pose, apples, caught, missed)
};
constexpr Arm picker{3, 2};          ///< the arm that catches them [m]
constexpr double hand_speed = 4;     ///< the most that its hand does [m/s]
constexpr double gravity = 10;       ///< [m/s²]
constexpr double catch_radius = 0.3; ///< an apple this near to the hand, or nearer, is caught [m]
constexpr double grass = -3;         ///< an apple this low, or lower, is missed: y [m]

//> Next frame
/// The orchard one frame later. First the hand goes straight towards the pointer, or towards the nearest point it can reach,
/// as far as `hand_speed` allows; where that leads into the hole, it's at the nearest point it can reach. Its elbow bends
/// left. Then each apple falls: its speed grows by `gravity` times dt, then it moves with that. An apple within
/// `catch_radius` of the hand is caught; else one at or below the grass is missed; the others stay, in their order.
/// @param dt  [s], 0 to 1
/// @throws std::invalid_argument if dt isn't from 0 to 1.
Orchard next_frame(Orchard now, const Vec2 &pointer, double dt);

//> Continued
/// The pose that brings the hand to the target, or to the nearest point it can reach, and is nearest to `before`: either
/// elbow, any whole turns; the sum of both angles' changes is the smallest. So an arm that's led around its ring never jumps.
/// @throws std::invalid_argument if a length is not positive.
Pose continued(const Arm &arm, const Pose &before, const Vec2 &target);

//> CCD sweep
/// An arm after one sweep of cyclic coordinate descent: from the last joint to the first, each turns, the shorter way, until
/// the hand is in line with the target. A joint within 1e-9 m of the hand or of the target stays as it is.
/// @throws std::invalid_argument if a length is negative.
std::vector<Link> ccd_sweep(const Vec2 &base, std::vector<Link> links, const Vec2 &target);

//> Limits
/// How far a joint can bend.
struct Limits {
    double low{}, high{}; ///< the smallest and the largest angle [rad]
    COURSE_FIELDS("rad, rad", low, high)
};

//> Damped step
/// An arm after one step of damped least squares. The angles change by Δ = Jᵀ (J Jᵀ + damping² I)⁻¹ (target - hand), where
/// the columns of J are 9.5's; then each angle is brought into its limits. While a joint or the hand would be more than
/// 1e-9 m below the ground, y = 0, Δ is halved and tried again, at most ten times; then the arm stays as it is.
/// @param limits   one for each link
/// @param damping  how much the step hesitates, at least 1e-6 [m]
/// @throws std::invalid_argument if there isn't one limit for each link, if a lower limit is above its upper one, if
///         the damping is less than 1e-6, or if a length is negative.
std::vector<Link> damped_step(const Vec2 &base, const std::vector<Link> &links, const std::vector<Limits> &limits,
                              const Vec2 &target, double damping);

//> Write
/// The poses that draw a path, a letter for example: straight strokes from each corner to the next. The first pose is
/// `start`, whose hand is at the first corner; in the last one the hand is at the last corner. From each pose to the next no
/// angle changes by more than 0.1 rad. In each the hand is within 1e-6 m of the path, in the path's order, and each corner
/// is visited; halfway between two poses, angles halfway, it's within 2 mm of the path. At most 1000 poses, for a
/// path that takes a few hundred.
/// @throws std::invalid_argument if the path has no corner, if the hand doesn't start within 1e-6 m of the first one,
///         if the path isn't at least 0.1 m from where the reach ends, inside and outside, or if a length is not
///         positive.
std::vector<Pose> write(const Arm &arm, const Pose &start, const std::vector<Vec2> &path);

//>
namespace subject {
COURSE_EXERCISE("10.1", core, inverse_kinematics, point_at, "joint [m], target [m]", "rad")
COURSE_EXERCISE("10.2", core, inverse_kinematics, poses, "arm, target [m]", "")
COURSE_EXERCISE("10.3", core, inverse_kinematics, nearest_reachable, "arm, target [m]", "m")
COURSE_EXERCISE("10.4", core, inverse_kinematics, next_frame, "now, pointer [m], dt [s]", "")
COURSE_EXERCISE("10.5", stretch, inverse_kinematics, continued, "arm, before, target [m]", "")
COURSE_EXERCISE("10.6", stretch, inverse_kinematics, ccd_sweep, "base [m], links, target [m]", "")
COURSE_EXERCISE("10.7", challenge, inverse_kinematics, damped_step, "base [m], links, limits, target [m], damping [m]",
                "")
COURSE_EXERCISE("10.8", challenge, inverse_kinematics, write, "arm, start, path [m]", "")
} // namespace subject
} // namespace inverse_kinematics
