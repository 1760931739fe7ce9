#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 9: where the joints and the hand of an arm are.
/// Angles are in radians and go anticlockwise, as many turns as you like. Numbers that go in are within ±1e5; an arm
/// that gets farther may be refused. Ten digits must be right; where fewer will do, the tests say.
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
/// @throws std::invalid_argument if a length is negative.
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
Frame compose(const Frame &outer, const Frame &inner);

//> Joints
/// All joints of an arm with any number of links, from `base` to the hand [m]: one more than there are links.
/// @throws std::invalid_argument if a length is negative.
std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links);

//> A digger and a stone
/// A digger on level ground, the line y = 0, and a stone.
struct Site {
    double place{};                   ///< of the boom's joint, along x [m]; it's `boom_height` above the ground
    double boom{}, stick{}, bucket{}; ///< each angle as in a Link [rad]
    Vec2 stone;                       ///< [m]
    bool held = false;                ///< whether the bucket has the stone
    COURSE_FIELDS("m, rad, rad, rad, m, ", place, boom, stick, bucket, stone, held)
};
constexpr double boom_height = 1.2, boom_length = 3.2, stick_length = 2.4, bucket_length = 0.7; ///< [m]

//> The handles
/// How far the driver pushes each handle, from -1 to 1, and whether the bucket is closed.
struct Handles {
    double drive{}, boom{}, stick{}, bucket{};
    bool closed = false;
    COURSE_FIELDS("1, 1, 1, 1, ", drive, boom, stick, bucket, closed)
};

//> One frame of the digger
/// The site one frame later. First everything moves: a handle pushed all the way drives at 2 m/s, or turns its joint at
/// 0.8 rad/s. Then a closed bucket pulls a stone within 0.3 m of its teeth, which are at its end, to the teeth, and holds
/// it there until it opens. Last, a stone that isn't held comes down at 4 m/s, and lies on the ground.
/// @param dt  [s], 0 to 1
/// @throws std::invalid_argument if a handle is beyond ±1, or if dt isn't from 0 to 1.
Site next_frame(Site now, const Handles &handles, double dt);

//> Jacobian
/// One vector for each link [m/rad]: the velocity of the hand [m/s] while that link's angle grows by 1 rad/s, and no other
/// angle changes. These are the columns of the arm's Jacobian matrix.
/// @throws std::invalid_argument if a length is negative.
std::vector<Vec2> jacobian(const std::vector<Link> &links);

//> To local
/// A point of the world, as seen from a frame [m]. It undoes what `compose` does to an origin.
Vec2 to_local(const Frame &frame, const Vec2 &point);

//> Turn above ground
/// How far one joint can turn before the arm touches the ground, the line y = 0 [rad]: `by`, or less of it, with the same
/// sign. All links from that joint on turn with it, as one stiff piece, and none of it goes through the ground. What lies
/// on the ground already, or up to 1e-5 m deep, may be lifted, but not pushed in.
/// @param joint  which angle changes: 0 for the first link's
/// @param by     how far you'd like it to turn [rad]; negative: clockwise
/// @throws std::invalid_argument if a joint or the hand starts more than 1e-5 m below the ground, if there is no such
///         link, or if a length is negative.
double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by);

//> A crane on a wall
/// An arm with two links on top of a post above a wall. The wall is the line x = 0 from the ground, y = 0, up; the post is
/// not in the way.
struct Crane {
    double height{};          ///< of the first joint, which is at (0, height) [m]
    double first{}, second{}; ///< lengths, neither more than `height` [m]
    double wall{};            ///< its height, less than `height` [m]
    COURSE_FIELDS("m, m, m, m", height, first, second, wall)
};
struct Pose {
    double first{}, second{}; ///< angles, as in a Link [rad]
    COURSE_FIELDS("rad, rad", first, second)
};

//> Over the wall
/// The poses that carry a load from `start`, on the left of the wall, to `goal`, on its right. The first pose is `start`,
/// the last is `goal`, either one give or take whole turns, and from each to the next no angle changes by more than
/// 0.1 rad. In none of them is the elbow or the hand below the ground, and no link touches the wall. At most 10000 will do.
/// @throws std::invalid_argument if elbow and hand aren't on their side of the wall and above the ground in `start` and in
///         `goal`, if a first angle isn't within ±2π, a second one within ±3.1, or a length or height is not as it must be.
std::vector<Pose> over_the_wall(const Crane &crane, const Pose &start, const Pose &goal);

//>
namespace subject {
COURSE_EXERCISE("9.1", core, forward_kinematics, two_links, "first, second", "")
COURSE_EXERCISE("9.2", core, forward_kinematics, compose, "outer, inner", "")
COURSE_EXERCISE("9.3", core, forward_kinematics, joints, "base [m], links", "m")
COURSE_EXERCISE("9.4", core, forward_kinematics, next_frame, "now, handles, dt [s]", "")
COURSE_EXERCISE("9.5", stretch, forward_kinematics, jacobian, "links", "m/rad")
COURSE_EXERCISE("9.6", stretch, forward_kinematics, to_local, "frame, point [m]", "m")
COURSE_EXERCISE("9.7", challenge, forward_kinematics, turn_above_ground, "base [m], links, joint, by [rad]", "rad")
COURSE_EXERCISE("9.8", challenge, forward_kinematics, over_the_wall, "crane, start, goal", "")
} // namespace subject
} // namespace forward_kinematics
