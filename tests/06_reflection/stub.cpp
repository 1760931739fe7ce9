// Section 6, Reflection. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 6
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "reflection.hpp"

#include <algorithm>
#include <cmath>

namespace reflection {

static void require_ball_in_box(const Ball &ball, const Box &box) {
    course::require(ball.radius >= 0, "radius [m] must not be negative", ball.radius);
    const double room = (box.high - box.low).minCoeff() - 2 * ball.radius;
    course::require(room > 0, "the box must be wider and higher than the ball: its room [m] must be positive", room);
}

// 6.1 core
Vec2 bounce_in_box(const Ball &ball, const Box &box) {
    require_ball_in_box(ball, box);
    throw course::NotYet{"where are the edges of the ball, and which side has one of them passed?"};
}

static void require_normal(const Vec2 &normal) {
    course::require(normal.norm() > 0, "the length of the normal must be positive", normal.norm());
}

// 6.2 core
Vec2 reflect(const Vec2 &velocity, const Vec2 &normal) {
    require_normal(normal);
    throw course::NotYet{"what is the normal part of the velocity?"};
}

// 6.3 core
Vec2 unit_normal(const Vec2 &start, const Vec2 &end) {
    const double length = (end - start).norm(); // of the wall [m]
    course::require(length > 0, "the length of the wall [m] must be positive", length);
    throw course::NotYet{"how far does the wall go to the right, and how far up?"};
}

static void require_surface(const Surface &surface) {
    course::require(surface.restitution >= 0, "restitution must not be negative", surface.restitution);
    course::require(surface.mu_k >= 0, "mu_k must not be negative", surface.mu_k);
}

// 6.4 stretch
Vec2 bounce(const Vec2 &velocity, const Vec2 &normal, const Surface &surface) {
    require_normal(normal);
    require_surface(surface);
    throw course::NotYet{"what are the normal part and the tangential part of the velocity?"};
}

// 6.5 stretch
Vec2 bounce_in_rotated_box(const Ball &ball, const Box &box, double angle) {
    require_ball_in_box(ball, box);
    throw course::NotYet{"where is the ball, as seen from the box?"};
}

static void require_inside(const Ball &ball, const Vec2 &centre, const Box &table) {
    const double room = std::min((centre - table.low).minCoeff(), (table.high - centre).minCoeff()) - ball.radius;
    course::require(room >= -1e-9, "a centre must not be closer to a side than the radius: its distance [m]", room);
}

// 6.6 challenge
Vec2 bank_shot(const Ball &ball, const Vec2 &target, const Box &table, int across, int up) {
    require_ball_in_box(ball, table);
    require_inside(ball, ball.position, table);
    require_inside(ball, target, table);
    course::require(across >= -100 && across <= 100, "across must be from -100 to 100", across);
    course::require(up >= -100 && up <= 100, "up must be from -100 to 100", up);
    // This line refuses a ball that is at the image. Put it below your `way` from one to the other, without its slashes:
    // course::require(way.norm() > 0, "the ball must not be at the image already: its distance [m]", way.norm());
    throw course::NotYet{"where does the ball see the target, so many mirrors away?"};
}

static void require_pinball(const Pinball &now, double dt) {
    course::require(now.ball.radius >= 0, "radius [m] of the ball must not be negative", now.ball.radius);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const Bumper &bumper : now.bumpers) {
        course::require(bumper.radius >= 0, "radius [m] of a bumper must not be negative", bumper.radius);
        require_surface(bumper.surface);
    }
}

// 6.7 challenge
Pinball play_pinball(Pinball now, const Vec2 &pull, double dt) {
    require_pinball(now, dt);
    throw course::NotYet{"where does the ball get to, and which point of a bumper is nearest to it then?"};
}

} // namespace reflection
