// 7.4: complex numbers: each wall is turned onto the x axis, where a bounce is a conjugate
#include "segment_intersection.hpp"

#include <algorithm>
#include <complex>

namespace segment_intersection {

using Complex = std::complex<double>;

Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    std::vector<Complex> corners;
    for (const Vec2 &corner : room) corners.emplace_back(corner.x(), corner.y());
    double turned = 0; // the sum of the angles by which the walls turn: +-2 pi
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Complex before = corners[i] - corners[(i + n - 1) % n], after = corners[(i + 1) % n] - corners[i];
        course::require(after != 0.0, "the length of a wall [m] must be positive", 0);
        turned += std::arg(after / before);
    }
    if (turned < 0) std::reverse(corners.begin(), corners.end());

    Complex place{ball.position.x(), ball.position.y()}, speed{ball.velocity.x(), ball.velocity.y()};
    for (int bounces = max_bounces; bounces > 0; --bounces) {
        double soonest = dt;
        Complex ahead = 0; // along the wall that is hit
        for (std::size_t i = 0; i < n; ++i) {
            const Complex wall = corners[(i + 1) % n] - corners[i], along = wall / std::abs(wall);
            const Complex p = (place - corners[i]) / along, v = speed / along;
            if (v.imag() >= 0 || p.imag() < -contact_tolerance) continue;
            const double t = std::max(p.imag(), 0.0) / -v.imag(), s = p.real() + t * v.real();
            if (s < -contact_tolerance || s > std::abs(wall) + contact_tolerance || t > soonest
                || (t == soonest && ahead != 0.0))
                continue;
            soonest = t;
            ahead = along;
        }
        place += soonest * speed;
        dt -= soonest;
        if (ahead == 0.0) break;
        speed = std::conj(speed / ahead) * ahead;
    }
    return {{place.real(), place.imag()}, {speed.real(), speed.imag()}};
}

} // namespace segment_intersection
