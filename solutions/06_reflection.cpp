#include "reflection.hpp"

#include <algorithm>

namespace reflection {

//> Solution: a good ball in a good box
static void require_ball_in_box(const Ball &ball, const Box &box) {
    course::require(ball.radius >= 0, "radius [m] must not be negative", ball.radius);
    const double room = (box.high - box.low).minCoeff() - 2 * ball.radius;
    course::require(room > 0, "the box must be wider and higher than the ball: its room [m] must be positive", room);
}

//> Solution 6.1: bounce in a box
Vec2 bounce_in_box(const Ball &ball, const Box &box) {
    require_ball_in_box(ball, box);
    double x = ball.velocity.x(), y = ball.velocity.y();
    if (ball.position.x() - ball.radius < box.low.x() && x < 0) x = -x;
    if (ball.position.x() + ball.radius > box.high.x() && x > 0) x = -x;
    if (ball.position.y() - ball.radius < box.low.y() && y < 0) y = -y;
    if (ball.position.y() + ball.radius > box.high.y() && y > 0) y = -y;
    return {x, y};
}

//> Solution: a good normal
static void require_normal(const Vec2 &normal) {
    course::require(normal.norm() > 0, "the length of the normal must be positive", normal.norm());
}

//> Solution 6.2: reflect
Vec2 reflect(const Vec2 &velocity, const Vec2 &normal) {
    require_normal(normal);
    const Vec2 n = normal / normal.norm();
    return velocity - 2 * velocity.dot(n) * n; // once to stop at the wall, once more to leave it
}

//> Solution 6.3: unit normal
Vec2 unit_normal(const Vec2 &start, const Vec2 &end) {
    const Vec2 wall = end - start;
    course::require(wall.norm() > 0, "the length of the wall [m] must be positive", wall.norm());
    return Vec2{-wall.y(), wall.x()} / wall.norm();
}

//> Solution: a good surface
static void require_surface(const Surface &surface) {
    course::require(surface.restitution >= 0, "restitution must not be negative", surface.restitution);
    course::require(surface.mu_k >= 0, "mu_k must not be negative", surface.mu_k);
}

//> Solution 6.4: bounce off a surface
Vec2 bounce(const Vec2 &velocity, const Vec2 &normal, const Surface &surface) {
    require_normal(normal);
    require_surface(surface);
    const Vec2 n = normal / normal.norm();
    const double approach = -velocity.dot(n); // normal speed, towards the wall [m/s]
    if (approach <= 0) return velocity;

    const Vec2 tangential = velocity + approach * n;
    const double speed = tangential.norm();
    const double loss = surface.mu_k * (1 + surface.restitution) * approach; // at most [m/s]
    const double kept = speed > loss ? (speed - loss) / speed : 0;
    return kept * tangential + surface.restitution * approach * n;
}

//> Solution 6.5: bounce in a rotated box
static Vec2 turned(const Vec2 &v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Vec2 bounce_in_rotated_box(const Ball &ball, const Box &box, double angle) {
    require_ball_in_box(ball, box);
    const Ball seen{turned(ball.position, -angle), turned(ball.velocity, -angle), ball.radius}; // from the box
    return turned(bounce_in_box(seen, box), angle);
}

//> Solution 6.6: a bank shot
/// Where x is seen, so many mirrors away.
static double mirrored(double x, double low, double high, int count) {
    const double shifted = count * (high - low);
    return count % 2 == 0 ? shifted + x : shifted + low + high - x;
}

static void require_inside(const Ball &ball, const Vec2 &centre, const Box &table) {
    const double room = std::min((centre - table.low).minCoeff(), (table.high - centre).minCoeff()) - ball.radius;
    course::require(room >= -1e-9, "a centre must not be closer to a side than the radius: its distance [m]", room);
}

Vec2 bank_shot(const Ball &ball, const Vec2 &target, const Box &table, int across, int up) {
    require_ball_in_box(ball, table);
    require_inside(ball, ball.position, table);
    require_inside(ball, target, table);
    course::require(across >= -100 && across <= 100, "across must be from -100 to 100", across);
    course::require(up >= -100 && up <= 100, "up must be from -100 to 100", up);
    const Vec2 low = table.low + Vec2{ball.radius, ball.radius}, high = table.high - Vec2{ball.radius, ball.radius};
    const Vec2 image{mirrored(target.x(), low.x(), high.x(), across), mirrored(target.y(), low.y(), high.y(), up)};
    const Vec2 way = image - ball.position;
    course::require(way.norm() > 0, "the ball must not be at the image already: its distance [m]", way.norm());
    return way / way.norm();
}

//> Solution 6.7: play pinball
static void require_pinball(const Pinball &now, double dt) {
    course::require(now.ball.radius >= 0, "radius [m] of the ball must not be negative", now.ball.radius);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const Bumper &bumper : now.bumpers) {
        course::require(bumper.radius >= 0, "radius [m] of a bumper must not be negative", bumper.radius);
        require_surface(bumper.surface);
    }
}

/// The point of its middle line that's nearest to a place.
static Vec2 nearest(const Bumper &bumper, const Vec2 &place) {
    const Vec2 along = bumper.end - bumper.start;
    if (along.norm() == 0) return bumper.start;
    const double share = along.dot(place - bumper.start) / along.squaredNorm(); // 0 at its start, 1 at its end
    return bumper.start + std::clamp(share, 0.0, 1.0) * along;
}

/// Sets the ball back and bounces it, and says whether it touched.
static bool meet(Ball &ball, const Bumper &bumper) {
    const Vec2 middle = nearest(bumper, ball.position), apart = ball.position - middle;
    if (apart.norm() >= ball.radius + bumper.radius) return false;
    const Vec2 normal = apart / apart.norm(), edge = middle + bumper.radius * normal, arm = edge - bumper.start;
    const Vec2 moves = bumper.turning * Vec2{-arm.y(), arm.x()}; // of the edge [m/s]
    ball.velocity = moves + bounce(ball.velocity - moves, normal, bumper.surface);
    ball.position = edge + ball.radius * normal;
    return true;
}

Pinball play_pinball(Pinball now, const Vec2 &pull, double dt) {
    require_pinball(now, dt);
    if (now.over) return now;
    now.ball.velocity += dt * pull;
    now.ball.position += dt * now.ball.velocity;
    for (Bumper &bumper : now.bumpers) {
        const bool touches = meet(now.ball, bumper);
        if (touches && !bumper.touched) now.score += bumper.points;
        bumper.touched = touches;
    }
    now.over = now.ball.position.y() < 0;
    return now;
}
//>
} // namespace reflection
