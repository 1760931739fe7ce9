// Section 9, forward kinematics. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 9
// The lines above each `throw` refuse numbers that make no sense; leave them as they are.

#include "forward_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forward_kinematics {

static void require_link(const Link &link) {
    course::require(link.length >= 0, "length [m] must not be negative", link.length);
}

// 9.1 core
ElbowAndHand two_links(const Link &first, const Link &second) {
    require_link(first);
    require_link(second);
    throw course::NotYet{"how far along x, and how far along y, is the end of the first link?"};
}

// 9.2 core
Frame compose(const Frame &outer, const Frame &inner) {
    throw course::NotYet{"which way does the inner x axis point, if you walk along the outer axes?"};
}

static void require_links(const std::vector<Link> &links) {
    for (const Link &link : links) require_link(link);
}

// 9.3 core
std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links) {
    require_links(links);
    throw course::NotYet{"which way does a link point, and where does it begin?"};
}

static void require_handles(const Handles &handles) {
    for (const double handle : {handles.drive, handles.boom, handles.stick, handles.bucket})
        course::require(std::abs(handle) <= 1, "a handle goes from -1 to 1", handle);
}

// 9.4 core
Site next_frame(Site now, const Handles &handles, double dt) {
    require_handles(handles);
    course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt);
    throw course::NotYet{"where do the handles move everything, and where are the teeth then?"};
}

// 9.5 stretch
std::vector<Vec2> jacobian(const std::vector<Link> &links) {
    require_links(links);
    throw course::NotYet{"where is the hand, as seen from each joint?"};
}

// 9.6 stretch
Vec2 to_local(const Frame &frame, const Vec2 &point) {
    throw course::NotYet{"where is the point, as seen from the origin of the frame?"};
}

static void require_above_ground(const std::vector<Vec2> &points) {
    for (const Vec2 &point : points)
        course::require(point.y() >= -1e-5, "each joint and the hand must be above the ground, y [m]", point.y());
}

// 9.7 challenge
double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by) {
    require_links(links);
    course::require(joint >= 0 && joint < int(links.size()), "joint must be the index of a link", joint);
    const std::vector<Vec2> all = joints(base, links); // yours, of 9.3
    require_above_ground(all);
    throw course::NotYet{"at which angle, as seen from the joint, does each of the others meet the ground?"};
}

static void require_pose(const Crane &crane, const Pose &pose, double side) {
    course::require(std::abs(pose.first) <= 2 * std::numbers::pi, "the first angle must be within ±2π", pose.first);
    course::require(std::abs(pose.second) <= 3.1, "the second angle must be within ±3.1", pose.second);
    const auto [elbow, hand] = two_links({crane.first, pose.first}, {crane.second, pose.second});
    for (const Vec2 &point : {elbow, hand}) {
        course::require(side * point.x() > 0, "elbow and hand must be on their side of the wall, x [m]", point.x());
        const double height = crane.height + point.y();
        course::require(height >= -1e-9, "elbow and hand must be above the ground, y [m]", height);
    }
}
static void require_crane(const Crane &crane) {
    course::require(crane.wall >= 0 && crane.wall < crane.height, "the wall must be lower than the crane", crane.wall);
    for (const double length : {crane.first, crane.second})
        course::require(length > 0 && length <= crane.height, "a link must not be longer than the crane is high",
                        length);
}

// 9.8 challenge
std::vector<Pose> over_the_wall(const Crane &crane, const Pose &start, const Pose &goal) {
    require_crane(crane);
    require_pose(crane, start, -1);
    require_pose(crane, goal, 1);
    throw course::NotYet{"which list of poses leads from one to the other? Try the simplest that you can think of"};
}

} // namespace forward_kinematics
