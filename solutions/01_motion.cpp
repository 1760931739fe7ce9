#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace motion {

//> Solution 1.1: pixels per second
double px_per_second(double px_per_frame, double frames_per_second) {
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    return px_per_frame * frames_per_second;
}

//> Solution 1.2: uniform motion
Vec2 uniform_motion(const Vec2 &start, const Vec2 &velocity, double t) {
    return start + t * velocity; // so far from where it started
}

//> Solution 1.3: accelerated motion
State accelerated_motion(const State &start, const Vec2 &acceleration, double t) {
    const Vec2 last = start.velocity + t * acceleration;
    const Vec2 average = 0.5 * (start.velocity + last); // its velocity grows evenly
    return {start.position + t * average, last};
}

//> Solution 1.4: centre of mass
std::optional<Vec2> centre_of_mass(const std::vector<PointMass> &bodies) {
    double total = 0;       // [kg]
    Vec2 weighted = {0, 0}; // [m kg]
    for (const PointMass &body : bodies) {
        course::require(body.mass >= 0, "mass [kg] must not be negative", body.mass);
        total += body.mass;
        weighted += body.mass * body.position;
    }
    if (total == 0) return {};
    return weighted / total;
}

//> Solution 1.5: three integrators
Integrators step_all(const Integrators &before, const Vec2 &acceleration, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);

    const Vec2 gained = dt * acceleration;
    Integrators after = before;
    after.explicit_euler.position += dt * before.explicit_euler.velocity; // as fast as it was
    after.explicit_euler.velocity += gained;
    after.semi_implicit.velocity += gained;
    after.semi_implicit.position += dt * after.semi_implicit.velocity; // as fast as it is now
    after.exact.velocity += 0.5 * gained;
    after.exact.position += dt * after.exact.velocity; // as fast as in the middle of the step
    after.exact.velocity += 0.5 * gained;
    return after;
}

//> Solution 1.6: the centroid of a plate
Vec2 centroid(const std::vector<Vec2> &corners) {
    course::require(corners.size() >= 3, "the number of corners must be three or more", double(corners.size()));
    double size = 0; // the square of the longest distance between two corners [m²]
    for (const Vec2 &p : corners)
        for (const Vec2 &q : corners) size = std::max(size, (p - q).squaredNorm());

    const Vec2 origin = corners[0]; // near the plate, so that no digits are lost far away
    double area = 0;                // with its sign [m²]
    Vec2 weighted = {0, 0};         // [m³]
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec2 p = corners[i] - origin, q = corners[i + 1] - origin;
        const double triangle = (p.x() * q.y() - p.y() * q.x()) / 2; // negative if it runs clockwise
        area += triangle;
        weighted += triangle / 3 * (p + q); // its centroid is (p + q)/3: the third corner is at 0
    }
    course::require(std::abs(area) > 1e-12 * size, "the area [m²] must not be zero", area);
    return origin + weighted / area;
}

//> Solution 1.7: a motion through three samples
Motion fit_motion(const Sample &first, const Sample &second, const Sample &third) {
    const char *claim = "the times [s] must differ from each other";
    course::require(first.t != second.t && first.t != third.t, claim, first.t);
    course::require(second.t != third.t, claim, second.t);

    const double v_12 = (second.x - first.x) / (second.t - first.t); // its velocity midway between the first two times
    const double v_23 = (third.x - second.x) / (third.t - second.t); // and midway between the last two
    const double a = 2 * (v_23 - v_12) / (third.t - first.t);        // these two times are (t_3 - t_1)/2 apart
    const double v_0 = v_12 - a * (first.t + second.t) / 2;
    return {first.x - first.t * (v_0 + a * first.t / 2), v_0, a};
}

//> Solution 1.8: on the screen
Vec2 to_screen(const Vec2 &place, const Screen &screen) {
    course::require(screen.px_per_m > 0, "px_per_m must be positive", screen.px_per_m);
    const Vec2 away = screen.px_per_m * (place - screen.centre); // from the middle of the screen, y up [px]
    return screen.size / 2 + Vec2{away.x(), -away.y()};
}
//>
} // namespace motion
