#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 9: where the joints and the hand of an arm are.
/// Angles are in radians and go anticlockwise, as many turns as you like. Numbers beyond ±1e5 are refused, and an arm that
/// gets farther than that may be. How many digits must be right stands with the tests.
namespace forward_kinematics {

using course::Vec2;

//> A link
/// A stiff part of an arm, between two joints, or between the last joint and the hand.
struct Link {
    double length{}; ///< [m], never negative
    double angle{};  ///< how far it bends away from the link before it; the first one, from the x axis [rad]
    COURSE_FIELDS("m, rad", length, angle)
};

//> An elbow and a hand
/// Where an arm with two links bends, and where it ends.
struct ElbowAndHand {
    Vec2 elbow; ///< [m]
    Vec2 hand;  ///< the end effector [m]
    COURSE_FIELDS("m, m", elbow, hand)
};

//> Two links
/// The elbow and the hand of an arm with two links. Its first joint is at the origin.
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
ElbowAndHand two_links(const Link &first, const Link &second);

//> A frame
/// A frame of reference, turned and moved: the columns of a homogeneous matrix.
struct Frame {
    Vec2 x_axis{1, 0}; ///< of length 1 [1]
    Vec2 y_axis{0, 1}; ///< a quarter turn to the left of `x_axis` [1]
    Vec2 origin{0, 0}; ///< [m]
    COURSE_FIELDS("1, 1, m", x_axis, y_axis, origin)
};

//> Compose
/// You know `inner` as seen from `outer`; here it is as the world sees it.
/// @throws std::invalid_argument if a number is not within ±1e5.
Frame compose(const Frame &outer, const Frame &inner);

//> Joints
/// All joints of an arm with any number of links, from `base` to the hand [m]: one more than there are links.
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links);

//> Jacobian
/// One vector for each link [m/rad]: the velocity of the hand [m/s] while that link's angle grows by 1 rad/s, and no other
/// angle changes. These are the columns of the arm's Jacobian matrix.
/// @throws std::invalid_argument if a length is negative, or a number is not within ±1e5.
std::vector<Vec2> jacobian(const std::vector<Link> &links);

//> To local
/// A point of the world, as seen from a frame [m]. It undoes what `compose` does to an origin.
/// @throws std::invalid_argument if a number is not within ±1e5.
Vec2 to_local(const Frame &frame, const Vec2 &point);

//> Turn above ground
/// How far one joint can turn before the arm touches the ground, the line y = 0 [rad]: `by`, or less of it, with the same
/// sign. All links from that joint on turn with it, as one stiff piece, and none of it goes through the ground. What lies
/// on the ground already, or up to 1e-5 m deep, may be lifted, but not pushed in.
/// @param joint  which angle changes: 0 for the first link's
/// @param by     how far you'd like it to turn [rad]; negative: clockwise
/// @throws std::invalid_argument if a joint or the hand starts more than 1e-5 m below the ground, if there is no such link,
///         if a length is negative, or a number is not within ±1e5.
double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by);

//>
namespace subject {
COURSE_EXERCISE("9.1", core, forward_kinematics, two_links, "first, second", "")
COURSE_EXERCISE("9.2", core, forward_kinematics, compose, "outer, inner", "")
COURSE_EXERCISE("9.3", core, forward_kinematics, joints, "base [m], links", "m")
COURSE_EXERCISE("9.4", stretch, forward_kinematics, jacobian, "links", "m/rad")
COURSE_EXERCISE("9.5", stretch, forward_kinematics, to_local, "frame, point [m]", "m")
COURSE_EXERCISE("9.6", challenge, forward_kinematics, turn_above_ground, "base [m], links, joint, by [rad]", "rad")
} // namespace subject
} // namespace forward_kinematics
