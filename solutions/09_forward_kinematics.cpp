#include "forward_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forward_kinematics {

//> Solution: a good link
static void require_link(const Link &link) {
    course::require(link.length >= 0, "length [m] must not be negative", link.length);
}

//> Solution: a direction
static Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

//> Solution 9.1: two links
ElbowAndHand two_links(const Link &first, const Link &second) {
    require_link(first);
    require_link(second);
    const Vec2 elbow = first.length * at_angle(first.angle);
    return {elbow, elbow + second.length * at_angle(first.angle + second.angle)};
}

//> Solution: a vector of a frame
static Vec2 seen_from_the_world(const Frame &frame, const Vec2 &v) {
    return v.x() * frame.x_axis + v.y() * frame.y_axis;
}

//> Solution 9.2: compose
Frame compose(const Frame &outer, const Frame &inner) {
    return {seen_from_the_world(outer, inner.x_axis), seen_from_the_world(outer, inner.y_axis),
            outer.origin + seen_from_the_world(outer, inner.origin)};
}

//> Solution: good links
static void require_links(const std::vector<Link> &links) {
    for (const Link &link : links) require_link(link);
}

//> Solution 9.3: joints
std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links) {
    require_links(links);
    std::vector<Vec2> all{base};
    double angle = 0; // of the link, as the world sees it [rad]
    for (const Link &link : links) {
        angle += link.angle;
        all.push_back(all.back() + link.length * at_angle(angle));
    }
    return all;
}

//> Solution: handles
static void require_handles(const Handles &handles) {
    for (const double handle : {handles.drive, handles.boom, handles.stick, handles.bucket})
        course::require(std::abs(handle) <= 1, "a handle goes from -1 to 1", handle);
}

//> Solution 9.4: one frame of the digger
Site next_frame(Site now, const Handles &handles, double dt) {
    require_handles(handles);
    course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt);
    now.place += dt * 2 * handles.drive;
    now.boom += dt * 0.8 * handles.boom;
    now.stick += dt * 0.8 * handles.stick;
    now.bucket += dt * 0.8 * handles.bucket;
    const Vec2 teeth = joints({now.place, boom_height},
                              {{boom_length, now.boom}, {stick_length, now.stick}, {bucket_length, now.bucket}})
                           .back();

    if (!handles.closed) now.held = false;
    else if ((teeth - now.stone).norm() <= 0.3) now.held = true;
    if (now.held) now.stone = teeth;
    else now.stone.y() = std::max(0.0, now.stone.y() - dt * 4);
    return now;
}

//> Solution 9.5: Jacobian
std::vector<Vec2> jacobian(const std::vector<Link> &links) {
    require_links(links);
    const std::vector<Vec2> all = joints({0, 0}, links);
    std::vector<Vec2> columns;
    for (int i = 0; i < int(links.size()); ++i) {
        const Vec2 arm = all.back() - all[i];   // from the joint to the hand
        columns.push_back({-arm.y(), arm.x()}); // a quarter turn to the left of it
    }
    return columns;
}

//> Solution 9.6: to local
Vec2 to_local(const Frame &frame, const Vec2 &point) {
    const Vec2 way = point - frame.origin;
    return {way.dot(frame.x_axis), way.dot(frame.y_axis)};
}

//> Solution: nothing below the ground
static void require_above_ground(const std::vector<Vec2> &points) {
    for (const Vec2 &point : points)
        course::require(point.y() >= -1e-5, "each joint and the hand must be above the ground, y [m]", point.y());
}

//> Solution: down to the ground
/// How far a point can turn about a joint, anticlockwise, until it goes below the ground [rad].
static double turn_until_below(const Vec2 &arm, double height) {
    const double radius = arm.norm();
    if (radius <= height) return 2 * course::largest; // its circle is above the ground
    const double dip = std::asin(height / radius);    // its circle meets the ground at -dip, and at pi + dip
    const double above = std::numbers::pi + 2 * dip;  // the part of the circle between them
    const double turn = std::numbers::pi + dip - std::atan2(arm.y(), arm.x());
    // On a way that is longer than this it would go through the lowest point of its circle: there is a whole turn too
    // much. A rest below 0 says that it is a hair below the ground already.
    return turn > above / 2 + std::numbers::pi ? std::max(0.0, turn - 2 * std::numbers::pi) : turn;
}

//> Solution 9.7: turn above ground
double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by) {
    require_links(links);
    course::require(joint >= 0 && joint < int(links.size()), "joint must be the index of a link", joint);
    const std::vector<Vec2> all = joints(base, links);
    require_above_ground(all);

    double turn = std::abs(by);
    for (int i = joint + 1; i < int(all.size()); ++i) {
        Vec2 arm = all[i] - all[joint];
        if (by < 0) arm.x() = -arm.x(); // in a mirror, clockwise is anticlockwise
        turn = std::min(turn, turn_until_below(arm, std::max(0.0, all[joint].y())));
    }
    return by < 0 ? -turn : turn;
}

//> Solution: a good crane
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

//> Solution: to another pose
/// Goes on from the last pose in equal small turns.
static void turn_to(std::vector<Pose> &poses, const Pose &there) {
    const Pose from = poses.back();
    const double far = std::max(std::abs(there.first - from.first), std::abs(there.second - from.second));
    const int steps = int(far / 0.09) + 1;
    for (int i = 1; i <= steps; ++i) {
        const double part = double(i) / steps;
        poses.push_back(
            {from.first + part * (there.first - from.first), from.second + part * (there.second - from.second)});
    }
}

//> Solution 9.8: over the wall
std::vector<Pose> over_the_wall(const Crane &crane, const Pose &start, const Pose &goal) {
    require_crane(crane);
    require_pose(crane, start, -1);
    require_pose(crane, goal, 1);
    const double up = std::numbers::pi / 2;
    const auto from_up = [&](double angle) { return std::remainder(angle - up, 2 * std::numbers::pi); };
    // As it is, until the first link points up: what's on the left goes up, too. Then the elbow, high above the wall. And
    // down as it's going to be, which is the first part backwards, in a mirror.
    std::vector<Pose> poses{start};
    turn_to(poses, {start.first - from_up(start.first), start.second});
    turn_to(poses, {start.first - from_up(start.first), goal.second});
    turn_to(poses, {start.first - from_up(start.first) + from_up(goal.first), goal.second});
    return poses;
}
//>
} // namespace forward_kinematics
