#pragma once
// A ball on felt, and what it bounces off.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace reflection;

constexpr double speed = 5; ///< of each ball [m/s]

/// A white ball with a stripe, which turns as the ball rolls: it has come so far [m].
inline void rolling_ball(Canvas &canvas, const Vec2 &at, double radius, const Vec2 &velocity, double way) {
    canvas.ball(at, radius, Colour::ink);
    if (velocity.norm() <= 0) return;
    const Vec2 ahead = velocity.normalized(), side = turned(ahead);
    const double phase = way / radius, bulge = std::cos(phase) > 0 ? std::sin(phase) : -std::sin(phase);
    std::vector<Vec2> stripe;
    for (int i = 0; i <= 8; ++i) {
        const Vec2 on = at_angle(i * std::numbers::pi / 8);
        stripe.push_back(at + 0.9 * radius * (on.x() * side + bulge * on.y() * ahead));
    }
    canvas.line(std::move(stripe), Colour::orange, 4);
}

/// A wall of wood with inlays from one point to another, and a cushion on its left.
inline void draw_wall(Canvas &canvas, const Vec2 &start, const Vec2 &end) {
    const Vec2 along = (end - start).normalized(), out = turned(along);
    canvas.body({start - 0.25 * out, end - 0.25 * out, end - 1.1 * out, start - 1.1 * out}, Colour::wood);
    canvas.body({start, end, end - 0.3 * out, start - 0.3 * out}, Colour::green);
    std::vector<Vec2> inlays;
    for (double x = 0.5; x < (end - start).norm(); x += 1.2) inlays.push_back(start + x * along - 0.7 * out);
    canvas.dots(std::move(inlays), 0.09, Colour::amber);
}

/// A ball comes from above to a wall through the origin, again and again, and waits while the reader's hand is down.
struct ThrowScene : Scene {
    static constexpr double top = 4.4; ///< where it comes from [m]
    const Vec2 before{0, -speed};      ///< its velocity as it comes [m/s]
    Ball ball{{0, top}, {0, -speed}, 0.36};
    bool met = false; ///< whether it has met the wall
    double pause = 0; ///< until it comes, once it's gone [s]
    std::vector<Vec2> path;
    Knock knock;

    View view() const override { return {{-6.4, -2.6}, {6.4, 4.6}, Stage::felt}; }
    /// A frame for the ball.
    virtual void move(double dt) = 0;
    /// Where it's going to come anew.
    virtual void next_throw() {}
    void throw_ball() {
        ball = {{0, top}, before, ball.radius};
        met = false;
        pause = 0;
        path.clear();
    }
    void changed() override { throw_ball(); }
    void step(double dt) override {
        knock.age += dt;
        if (hand.down) return;
        if (pause > 0) {
            if ((pause -= dt) <= 0) throw_ball();
            return;
        }
        const Vec2 was = ball.velocity;
        move(dt);
        path.push_back(ball.position);
        if ((ball.velocity - was).norm() > 1e-9) {
            met = true;
            knock = {ball.position - ball.radius * (ball.velocity - was).normalized(),
                     (ball.velocity - was).normalized(), 0};
        }
        const bool seen = std::abs(ball.position.x()) < 6.9 && std::abs(ball.position.y() - 1) < 4.1;
        if (seen && path.size() < 300) return;
        pause = 0.7;
        next_throw();
    }
    void draw_ball(Canvas &canvas) const {
        canvas.trail(path, Colour::orange, 6);
        knock.draw(canvas);
        rolling_ball(canvas, ball.position, ball.radius, ball.velocity, speed * double(path.size()) * step_time());
    }
};
} // namespace play
