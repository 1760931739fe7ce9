#include "inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

using forward_kinematics::jacobian;
using forward_kinematics::joints;

namespace inverse_kinematics {

//> Solution 10.1: point at
double point_at(const Vec2 &joint, const Vec2 &target) {
    if (joint == target) return 0; // where a -0 is in it, atan2 would say half a turn
    return std::atan2(target.y() - joint.y(), target.x() - joint.x());
}

//> Solution: a good arm
static void require_arm(const Arm &arm) {
    for (const double length : {arm.first, arm.second})
        course::require(length > 0, "length [m] must be positive", length);
}

//> Solution: angles
static constexpr double pi = std::numbers::pi;
/// The same direction, by the shortest turn from the x axis: from -π to π.
static double shortest(double angle) { return std::remainder(angle, 2 * pi); }
/// The same direction again, by whole turns as near to another angle as it gets.
static double nearest_turn(double angle, double to) { return to + shortest(angle - to); }
/// Where an arrow points.
static double angle_of(const Vec2 &arrow) { return std::atan2(arrow.y(), arrow.x()); }

//> Solution: the hand
static Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
static Vec2 hand_of(const Arm &arm, const Pose &pose) {
    return arm.first * at_angle(pose.first) + arm.second * at_angle(pose.first + pose.second);
}

//> Solution: reach
static double distance(const Vec2 &target) { return std::hypot(target.x(), target.y()); }
static double far_border(const Arm &arm) { return arm.first + arm.second; }
static double near_border(const Arm &arm) { return std::abs(arm.first - arm.second); }

//> Solution 10.2: both poses
/// How far the second link bends when the hand is so far from the first joint [rad], by half the angle: an acos would lose
/// half of its digits near ±1, and be no number beyond.
static double bend(const Arm &arm, double r) {
    const double out = (far_border(arm) - r) * (far_border(arm) + r),
                 in = (r - near_border(arm)) * (r + near_border(arm));
    return 2 * std::atan2(std::sqrt(std::max(0.0, out)), std::sqrt(std::max(0.0, in)));
}

/// The pose whose second angle is given, and whose hand lies in the target's direction.
static Pose turned_to(const Arm &arm, double second, const Vec2 &target) {
    const Vec2 hand = hand_of(arm, {0, second}); // with the first link along the x axis
    return {shortest(angle_of(target) - angle_of(hand)), second};
}

std::vector<Pose> poses(const Arm &arm, const Vec2 &target) {
    require_arm(arm);
    const double r = distance(target), a_hair = 1e-12 * far_border(arm);
    if (r > far_border(arm) + a_hair || r < near_border(arm) - a_hair) return {};
    if (r >= far_border(arm)) return {turned_to(arm, 0, target)};
    if (r == 0 && near_border(arm) == 0) return {{0, pi}};
    if (r <= near_border(arm)) return {turned_to(arm, pi, target)};
    return {turned_to(arm, bend(arm, r), target), turned_to(arm, -bend(arm, r), target)};
}

//> Solution 10.3: nearest reachable
Vec2 nearest_reachable(const Arm &arm, const Vec2 &target) {
    require_arm(arm);
    const double r = distance(target), there = std::clamp(r, near_border(arm), far_border(arm));
    if (there == r) return target;
    return r == 0 ? Vec2{there, 0} : Vec2{target / r * there};
}

//> Solution: on the way
/// A place on the way, at most so far from the start.
static Vec2 towards(const Vec2 &start, const Vec2 &goal, double at_most) {
    const Vec2 way = goal - start;
    return way.norm() <= at_most ? goal : Vec2{start + at_most / way.norm() * way};
}

//> Solution 10.4: one frame of the orchard
Orchard next_frame(Orchard now, const Vec2 &pointer, double dt) {
    course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt);
    const Vec2 goal = nearest_reachable(picker, pointer);
    const Vec2 place = towards(hand_of(picker, now.pose), goal, dt * hand_speed);
    now.pose = poses(picker, nearest_reachable(picker, place)).front();

    const Vec2 hand = hand_of(picker, now.pose);
    std::vector<Apple> in_the_air;
    for (Apple apple : now.apples) {
        apple.speed += dt * gravity;
        apple.place.y() -= dt * apple.speed;
        if ((apple.place - hand).norm() <= catch_radius) ++now.caught;
        else if (apple.place.y() <= grass) ++now.missed;
        else in_the_air.push_back(apple);
    }
    now.apples = in_the_air;
    return now;
}

//> Solution 10.5: continued
static double change(const Pose &one, const Pose &other) {
    return std::abs(one.first - other.first) + std::abs(one.second - other.second);
}

Pose continued(const Arm &arm, const Pose &before, const Vec2 &target) {
    const Vec2 place = nearest_reachable(arm, target);
    std::vector<Pose> all = poses(arm, place);
    if (place == Vec2{0, 0}) all = {{before.first, pi}}; // every first angle will do, so it stays
    for (Pose &each : all) each = {nearest_turn(each.first, before.first), nearest_turn(each.second, before.second)};
    return *std::min_element(all.begin(), all.end(), [&](const Pose &one, const Pose &other) {
        return change(one, before) < change(other, before);
    });
}

//> Solution: good links
static void require_links(const std::vector<Link> &links) {
    for (const Link &link : links) course::require(link.length >= 0, "length [m] must not be negative", link.length);
}

//> Solution 10.6: a CCD sweep
std::vector<Link> ccd_sweep(const Vec2 &base, std::vector<Link> links, const Vec2 &target) {
    require_links(links);
    std::vector<Vec2> all = joints(base, links);
    Vec2 hand = all.back();
    for (std::size_t i = links.size(); i-- > 0;) {
        const Vec2 to_hand = hand - all[i], to_target = target - all[i];
        if (to_hand.norm() <= 1e-9 || to_target.norm() <= 1e-9) continue;
        links[i].angle += shortest(angle_of(to_target) - angle_of(to_hand));
        hand = all[i] + to_hand.norm() * to_target.normalized(); // the joints before this one stay where they are
    }
    return links;
}

//> Solution: good limits
static void require_limits(const std::vector<Limits> &limits, std::size_t links) {
    course::require(limits.size() == links, "there must be one limit for each link, limits", double(limits.size()));
    for (const auto &[low, high] : limits)
        course::require(low <= high, "a lower limit must not be above its upper one", low);
}

//> Solution: least squares, damped
/// (J J^T + damping² 1)^-1 times the way, by elimination. Both pivots are sums of squares, so no rounding makes one 0.
static Vec2 solved(const std::vector<Vec2> &columns, const Vec2 &way, double damping) {
    double xx = damping * damping, xy = 0;
    for (const Vec2 &column : columns) {
        xx += column.x() * column.x();
        xy += column.x() * column.y();
    }
    const double part = xy / xx; // of the first row, which the second one loses
    double yy = damping * damping * (1 + part * part);
    for (const Vec2 &column : columns) yy += std::pow(column.y() - part * column.x(), 2);
    const double y = (way.y() - part * way.x()) / yy;
    return {(way.x() - xy * y) / xx, y};
}

static bool above_ground(const Vec2 &base, const std::vector<Link> &links) {
    const std::vector<Vec2> all = joints(base, links);
    return std::all_of(all.begin(), all.end(), [](const Vec2 &each) { return each.y() >= -1e-9; });
}

//> Solution 10.7: a damped step
std::vector<Link> damped_step(const Vec2 &base, const std::vector<Link> &links, const std::vector<Limits> &limits,
                              const Vec2 &target, double damping) {
    require_links(links);
    require_limits(limits, links.size());
    course::require(damping >= 1e-6, "damping [m] must be at least 1e-6", damping);
    const std::vector<Vec2> columns = jacobian(links);
    Vec2 pull = solved(columns, target - joints(base, links).back(), damping);
    for (int halved = 0; halved <= 10; ++halved, pull /= 2) {
        std::vector<Link> moved = links;
        for (std::size_t i = 0; i < links.size(); ++i)
            moved[i].angle = std::clamp(links[i].angle + columns[i].dot(pull), limits[i].low, limits[i].high);
        if (above_ground(base, moved)) return moved;
    }
    return links;
}

//> Solution: a good path
/// How near a stroke comes to the first joint [m].
static double nearest_on(const Vec2 &from, const Vec2 &to) {
    const Vec2 along = to - from;
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp(-from.dot(along) / length, 0.0, 1.0) : 0;
    return (from + part * along).norm();
}

static void require_path(const Arm &arm, const std::vector<Vec2> &path) {
    course::require(!path.empty(), "a path must have a corner, corners", 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double in = nearest_on(path[i == 0 ? 0 : i - 1], path[i]) - near_border(arm);
        const double out = far_border(arm) - path[i].norm();
        course::require(std::min(in, out) > 0.1 - 1e-9, "the path must keep 0.1 m from where the reach ends, [m]",
                        std::min(in, out));
    }
}

//> Solution 10.8: write
static bool small_enough(const Arm &arm, const Pose &from, const Pose &to, const Vec2 &middle) {
    const Pose halfway{(from.first + to.first) / 2, (from.second + to.second) / 2};
    return std::abs(to.first - from.first) <= 0.1 && std::abs(to.second - from.second) <= 0.1
           && (hand_of(arm, halfway) - middle).norm() <= 0.0019;
}

/// Draws a stroke from where the last pose's hand is: in one go, or else in two halves.
static void draw(const Arm &arm, std::vector<Pose> &all, const Vec2 &from, const Vec2 &to) {
    const Pose there = continued(arm, all.back(), to);
    const Vec2 middle = (from + to) / 2;
    if (small_enough(arm, all.back(), there, middle)) {
        all.push_back(there);
    } else {
        draw(arm, all, from, middle);
        draw(arm, all, middle, to);
    }
}

std::vector<Pose> write(const Arm &arm, const Pose &start, const std::vector<Vec2> &path) {
    require_arm(arm);
    require_path(arm, path);
    const double off = (hand_of(arm, start) - path.front()).norm();
    course::require(off <= 1e-6, "the hand must start at the first corner, but it's off by [m]", off);
    std::vector<Pose> all{start};
    for (std::size_t i = 1; i < path.size(); ++i) draw(arm, all, path[i - 1], path[i]);
    return all;
}
//>
} // namespace inverse_kinematics
