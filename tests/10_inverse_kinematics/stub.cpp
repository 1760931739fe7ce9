// Section 10, inverse kinematics. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 10
// The lines above each `throw` refuse numbers that make no sense; leave them as they are.

#include "inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

using forward_kinematics::jacobian; // where section 9's functions are called here, they are ours
using forward_kinematics::joints;
using forward_kinematics::two_links;

namespace inverse_kinematics {

// 10.1 core
double point_at(const Vec2 &joint, const Vec2 &target) {
    throw course::NotYet{"how far to the right of the joint is the target, and how far above it?"};
}

static void require_arm(const Arm &arm) {
    for (const double length : {arm.first, arm.second})
        course::require(length > 0, "length [m] must be positive", length);
}

// 10.2 core
std::vector<Pose> poses(const Arm &arm, const Vec2 &target) {
    require_arm(arm);
    throw course::NotYet{"how far is the target from the first joint, and how far can the hand get?"};
}

// 10.3 core
Vec2 nearest_reachable(const Arm &arm, const Vec2 &target) {
    require_arm(arm);
    throw course::NotYet{"how far from the first joint can the hand get at most, and how near to it?"};
}

// 10.4 core
Orchard next_frame(Orchard now, const Vec2 &pointer, double dt) {
    course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt);
    throw course::NotYet{"where is the hand now, where does it go, and how far does it get in this frame?"};
}

// 10.5 stretch
Pose continued(const Arm &arm, const Pose &before, const Vec2 &target) {
    require_arm(arm);
    throw course::NotYet{"which poses are there, and which of them is nearest to the one before?"};
}

static void require_links(const std::vector<Link> &links) {
    for (const Link &link : links) course::require(link.length >= 0, "length [m] must not be negative", link.length);
}

// 10.6 stretch
std::vector<Link> ccd_sweep(const Vec2 &base, std::vector<Link> links, const Vec2 &target) {
    require_links(links);
    throw course::NotYet{"from the last joint, which way is the hand, and which way is the target?"};
}

static void require_limits(const std::vector<Limits> &limits, std::size_t links) {
    course::require(limits.size() == links, "there must be one limit for each link, limits", double(limits.size()));
    for (const auto &[low, high] : limits)
        course::require(low <= high, "a lower limit must not be above its upper one", low);
}

// 10.7 challenge
std::vector<Link> damped_step(const Vec2 &base, const std::vector<Link> &links, const std::vector<Limits> &limits,
                              const Vec2 &target, double damping) {
    require_links(links);
    require_limits(limits, links.size());
    course::require(damping >= 1e-6, "damping [m] must be at least 1e-6", damping);
    throw course::NotYet{"how does the hand move when each angle grows, and which way should it go?"};
}

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
        const double in = nearest_on(path[i == 0 ? 0 : i - 1], path[i]) - std::abs(arm.first - arm.second);
        const double out = arm.first + arm.second - path[i].norm();
        course::require(std::min(in, out) > 0.1 - 1e-9, "the path must keep 0.1 m from where the reach ends, [m]",
                        std::min(in, out));
    }
}

// 10.8 challenge
std::vector<Pose> write(const Arm &arm, const Pose &start, const std::vector<Vec2> &path) {
    require_arm(arm);
    require_path(arm, path);
    const Vec2 hand = two_links({arm.first, start.first}, {arm.second, start.second}).hand;
    const double off = (hand - path.front()).norm();
    course::require(off <= 1e-6, "the hand must start at the first corner, but it's off by [m]", off);
    throw course::NotYet{"which list of poses draws one stroke? Try the simplest that you can think of"};
}

} // namespace inverse_kinematics
