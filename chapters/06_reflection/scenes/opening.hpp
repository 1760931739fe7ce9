#pragma once
// Which way does a slanted wall send a ball? A guess is an arrow; what's between it and the truth is said when it's known.
#include "shared.hpp"

namespace play {

struct Opening : ThrowScene {
    static constexpr std::string_view name = "you guess";
    const Vec2 normal{-0.6, 0.8}, meets{0, ball.radius / normal.y()}; ///< where the ball's centre is then [m]
    Handle aim = handle(meets + 2.8 * at_angle(100 * degree), {-6.4, -2.6}, {6.4, 4.6});
    int guesses = 0;

    Opening() { still_time = 1.2; }

    Vec2 guess() const { return (aim.at() - meets).normalized(); }
    void point(const Vec2 &way) {
        if (way.norm() > 0.01) aim.move(meets + 2.8 * way.normalized());
        throw_ball();
    }
    void take_over() override { throw_ball(); }
    void drag() override { point(aim.at() - meets); }
    void press(const Vec2 &at) override { point(at - meets); }
    void move(double dt) override {
        if (!untouched) return next_frame(ball, {0, 0}, normal, dt);
        if (ball.position.dot(normal) < ball.radius && !met) ball.velocity = speed * guess(); // it only wonders
        ball.position += dt * ball.velocity;
    }
    void next_throw() override {
        constexpr double film[]{210, 127, 60, 100}; // [°], and none of them is right
        if (untouched) aim.move(meets + 2.8 * at_angle(film[guesses++ % 4] * degree));
    }

    void draw(Canvas &canvas) const override {
        draw_wall(canvas, {-8, -6}, {8, 6});
        canvas.dotted({{0, top}, meets}, Colour::ink, 3);
        const Vec2 tip = aim.at();
        if (met && !untouched) {
            draw_angle(canvas, meets, 2.3, guess(), ball.velocity);
            canvas.arrow(meets, meets + 2.8 * ball.velocity.normalized(), Colour::orange, 5);
        }
        canvas.arrow(meets, tip, Colour::violet, 5);
        if (met && untouched) {
            canvas.dotted(arc(ball.position, 1.3 * ball.radius), Colour::ink, 3);
            canvas.text(ball.position - Vec2{0, 0.18}, "?", Colour::ink, 26, Anchor::middle);
            knock.draw(canvas);
        } else draw_ball(canvas);
        const bool known = met && !untouched;
        const double off = turn(guess(), ball.velocity) / degree, side = off > 0 ? 1 : -1;
        canvas.plate(tip + 0.5 * guess() - 0.6 * side * turned(guess()),
                     known ? number(std::abs(off), 0) + "° off" : "your guess", known ? Colour::amber : Colour::violet,
                     22);
        if (known)
            canvas.plate(ball.position + 0.9 * side * turned(ball.velocity.normalized()),
                         number(ball.velocity.norm(), 1, "m/s"), Colour::ink, 20);
    }
};
} // namespace play
