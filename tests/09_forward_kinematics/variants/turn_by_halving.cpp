// 9.7: small steps, and then halving the step in which something gets below the ground
#include "forward_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace forward_kinematics {

double turn_above_ground(const Vec2 &base, const std::vector<Link> &links, int joint, double by) {
    course::require_range(base, by);
    for (const Link &link : links) {
        course::require_range(link.length, link.angle);
        if (link.length < 0) throw std::invalid_argument{"no such link"};
    }
    if (joint < 0 || joint >= int(links.size())) throw std::invalid_argument{"no such joint"};
    std::vector<Vec2> at{base};
    double angle = 0;
    for (const Link &link : links) {
        angle += link.angle;
        at.push_back(at.back() + link.length * Vec2{std::cos(angle), std::sin(angle)});
    }
    for (const Vec2 &point : at)
        if (point.y() < -1e-5) throw std::invalid_argument{"below the ground"};

    double floor = -1e-10; // what is a hair below the ground may stay as low
    for (const Vec2 &point : at) floor = std::min(floor, point.y());
    const auto lowest = [&](double turn) {
        double y = at[joint].y();
        for (std::size_t i = joint + 1; i < at.size(); ++i) {
            const Vec2 arm = at[i] - at[joint];
            const Vec2 turned = Eigen::Rotation2Dd{turn} * arm;
            y = std::min(y, at[joint].y() + (turn == 0 ? arm.y() : turned.y()));
        }
        return y;
    };
    const double sign = by < 0 ? -1 : 1, all = std::min(std::abs(by), 7.0), step = 2e-4; // more than one turn is free
    for (double turned = 0; turned < all; turned += step) {
        if (lowest(sign * std::min(turned + step, all)) >= floor) continue;
        double above = turned, below = std::min(turned + step, all);
        for (int i = 0; i < 60; ++i) {
            const double middle = (above + below) / 2;
            (lowest(sign * middle) >= floor ? above : below) = middle;
        }
        return sign * above;
    }
    return by;
}

} // namespace forward_kinematics
