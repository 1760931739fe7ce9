#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 9: where the joints and the hand of an arm are.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger, but an arm with a joint or
/// its hand beyond ±1e5 m along x or y may be refused.
/// Angles are in radians, anticlockwise, and may be of any number of turns. An answer is right to ten digits of the
/// largest number that goes in, or of 1 if that is larger, unless its function says otherwise. Fewer digits do where
/// angles add up to more than 1000 rad.
namespace forward_kinematics {

using course::Vec2;

//> A link
/// A stiff part of an arm, between two joints, or between the last joint and the hand.
struct Link {
    double length{}; ///< [m], not negative
    double angle{}; ///< by how much it is turned, as seen from the link before it; the first one, from the x axis [rad]
    COURSE_FIELDS("m, rad", length, angle)
};

//> An elbow and a hand
/// Where an arm of two links bends, and where it ends.
struct ElbowAndHand {
    Vec2 elbow; ///< [m]
    Vec2 hand;  ///< the end effector [m]
    COURSE_FIELDS("m, m", elbow, hand)
};

//> Two links
/// The elbow and the hand of an arm of two links, whose first joint is at the origin.
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
ElbowAndHand two_links(const Link &first, const Link &second);

//> A frame
/// A frame of reference that is turned and moved: the first two columns of a homogeneous matrix are its axes, the third
/// is its origin. What a function answers for axes that are not as said here does not matter.
struct Frame {
    Vec2 x_axis{1, 0}; ///< of length 1 [1]
    Vec2 y_axis{0, 1}; ///< a quarter turn to the left of `x_axis` [1]
    Vec2 origin{0, 0}; ///< [m]
    COURSE_FIELDS("1, 1, m", x_axis, y_axis, origin)
};

//> Compose
/// The frame `inner`, which is given as seen from the frame `outer`, as the world sees it.
/// @throws std::invalid_argument if a number is not within ±1e5.
Frame compose(const Frame &outer, const Frame &inner);

//> Joints
/// All joints of an arm of any number of links, from the first, which is at `base`, to the hand, which is at the end of
/// the last link [m]: one more than there are links.
/// @param base   the first joint [m]
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links);

//> Jacobian
/// How the hand moves for each link's angle, one vector for each link [m/rad]: the velocity of the hand [m/s] if that
/// angle grows by 1 rad/s, and no other angle changes. These are the columns of the arm's Jacobian matrix.
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
std::vector<Vec2> jacobian(const std::vector<Link> &links);

//> To local
/// A point of the world, as seen from a frame [m]: the inverse of what `compose` does to an origin.
/// @throws std::invalid_argument if a number is not within ±1e5.
Vec2 to_local(const Frame &frame, const Vec2 &point);

//> Turn above ground
/// How far one joint can turn before the arm touches the ground, the line y = 0 [rad]: `by`, or less of it, with the same
/// sign. All links from that joint on turn with it, as one stiff piece; no joint of them, and not the hand, gets below
/// the ground on the way. One that is on the ground already allows no turn that takes it below, and any that lifts it.
/// No more than 1e-5 m below the ground counts as on it. A point that comes down to the ground on its way, and goes no
/// deeper than 1e-5 m, may end the turn there or not; one that stays where it is does not end it.
/// Where the turn ends early, what touches the ground is at y = 0, or no deeper than the arm was to begin with, to nine
/// digits of the largest number that goes in, or of 1 if that is larger.
/// @param base   the first joint [m]
/// @param joint  which angle changes: 0 for the first link's
/// @param by     how far it should turn [rad]; negative: clockwise
/// @throws std::invalid_argument if a joint or the hand is more than 1e-5 m below the ground to begin with, if there is no
///         such link, if a length is negative, or a number is not within ±1e5.
double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by);

//> The exercises
namespace subject {
COURSE_EXERCISE("9.1", core, forward_kinematics, two_links, "first, second", "")
COURSE_EXERCISE("9.2", core, forward_kinematics, compose, "outer, inner", "")
COURSE_EXERCISE("9.3", core, forward_kinematics, joints, "base [m], links", "m")
COURSE_EXERCISE("9.4", stretch, forward_kinematics, jacobian, "links", "m/rad")
COURSE_EXERCISE("9.5", stretch, forward_kinematics, to_local, "frame, point [m]", "m")
COURSE_EXERCISE("9.6", challenge, forward_kinematics, turn_above_ground, "base [m], links, joint, by [rad]", "rad")
} // namespace subject
//>
} // namespace forward_kinematics
