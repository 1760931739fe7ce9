#pragma once
// Newton's cradle. A press on a ball lifts it, and all to its left.
#include "shared.hpp"

namespace play {

struct Cradle : Scene {
    static constexpr std::string_view name = "cradle (2.6)";
    static constexpr double top = 6.4, string = 5; // where the strings begin, and how long they are [m]
    static constexpr double rest[]{4, 5, 6, 7, 8}; // where the balls hang [m]
    Choice lifted = choice("lifted", {"one ball", "two balls", "three balls"});
    std::vector<RailCart> balls;
    double time = 0; ///< [s]
    Clash clash;

    Cradle() { still_time = 1.3; }

    View view() const override { return {{-0.5, -0.4}, {12.5, 6.9125}, Stage::workshop, 0.3}; }
    void lift(int count) {
        balls.clear();
        for (int i = 0; i < 5; ++i) balls.push_back({rest[i] - (i < count ? 3 : 0), {1, 0}});
    }
    void begin() override { lift(lifted + 1); }
    void changed() override { begin(); }
    void press(const Vec2 &at) override { lift(std::clamp(int(std::round(at.x())) - 3, 1, 4)); }
    /// A ball on a string, for small swings: its place and velocity turn around each other, and no energy is lost.
    static void swing(RailCart &ball, double hangs_at, double dt) {
        const double w = std::sqrt(9.8 / string), half = w * dt / 2;
        const double c = (1 - half * half) / (1 + half * half), s = 2 * half / (1 + half * half); // c² + s² = 1
        const double aside = ball.x - hangs_at, velocity = ball.cart.velocity;
        ball.x = hangs_at + c * aside + s / w * velocity;
        ball.cart.velocity = c * velocity - s * w * aside;
    }
    void step(double dt) override {
        time += dt;
        clash.age += dt;
        for (std::size_t i = 0; i < balls.size(); ++i) swing(balls[i], rest[i], dt);
        const double first = balls.front().cart.velocity, last = balls.back().cart.velocity;
        next_frame(balls, 0); // they have moved; what touches collides
        if (std::abs(balls.front().cart.velocity - first) > 1) clash = {at(0) + Vec2{0.5, 0}, 0};
        if (std::abs(balls.back().cart.velocity - last) > 1) clash = {at(4) - Vec2{0.5, 0}, 0};
    }
    Vec2 at(std::size_t i) const {
        const double aside = std::clamp(balls[i].x - rest[i], -string, string);
        return {balls[i].x, top - std::sqrt(string * string - aside * aside)};
    }

    void draw(Canvas &canvas) const override {
        for (const double x : {1.6, 10.4}) {
            canvas.bar({{x - 0.9, 0.1}, {x, top + 0.1}}, Colour::wood, 8);
            canvas.bar({{x + 0.9, 0.1}, {x, top + 0.1}}, Colour::wood, 8);
        }
        canvas.bar({{1.2, top + 0.1}, {10.8, top + 0.1}}, Colour::wood, 10);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            canvas.line({{rest[i] - 0.25, top}, at(i)}, Colour::dim, 2);
            canvas.line({{rest[i] + 0.25, top}, at(i)}, Colour::dim, 2);
        }
        std::vector<Vec2> steel;
        for (std::size_t i = 0; i < balls.size(); ++i) steel.push_back(at(i));
        canvas.balls(std::move(steel), 0.5, Colour::dim);
        clash.draw(canvas, 0.3);
    }
};
} // namespace play
