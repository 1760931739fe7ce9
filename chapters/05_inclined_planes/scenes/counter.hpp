#pragma once
// A glass on a bar: a shove, and a coaster where it's going to stop.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace inclined_planes;

/// The ring at the arrow's tip sets the velocity, and the glass is shoved when it's let go.
struct CounterScene : Scene {
    static constexpr double scale = 0.9, aloft = 1.3; ///< of the arrow [s], and where it is [m]
    bool one_way;                                     ///< only to the right
    Handle tip;
    double time = 0;  ///< since the shove [s]
    double pause = 0; ///< until the next one, once it's over [s]
    int shoves = 0;
    std::vector<Vec2> path;

    explicit CounterScene(bool only_to_the_right)
        : one_way{only_to_the_right},
          tip{handle({scale * 6, aloft}, {scale * (one_way ? 1 : -6), aloft}, {scale * 6, aloft})} {}

    View view() const override { return {{-10.8, -3.2}, {10.8, 8.95}, Stage::skyline, -2}; }
    double velocity() const { return tip.at().x() / scale; } ///< of the shove [m/s]
    virtual void shove() = 0;
    virtual void move(double dt) = 0;
    virtual motion::State glass() const = 0;
    /// Whether there's nothing more to see.
    virtual bool over() const = 0;

    void start() {
        time = pause = 0;
        path.clear();
        shove();
    }
    void begin() override { start(); }
    void take_over() override {
        tip.move({scale * 6, aloft});
        start();
    }
    void drag() override { start(); }
    void step(double dt) override {
        if (hand.down) return;
        if (pause > 0) {
            if ((pause -= dt) > 0) return;
            constexpr double film[]{6, 4, 5};
            ++shoves;
            if (untouched) tip.move({scale * film[shoves % 3] * (shoves % 2 == 0 || one_way ? 1 : -1), aloft});
            return start();
        }
        for (int i = 0; i < 16; ++i) move(dt / 16); // so that the last part before it stops is short
        time += dt;
        path.push_back(glass().position + Vec2{0, 0.9});
        if (path.size() > 40) path.erase(path.begin());
        // Left alone it's never seen to stop: whether it does is the reader's to find out.
        if (untouched && time > 0.8 * std::abs(velocity()) / deceleration) pause = 0.01;
        else if (over()) pause = 1.5;
    }

    void draw(Canvas &canvas) const override {
        const double stop = stopping_distance(velocity(), deceleration);
        const auto [at, now] = glass();
        for (const double x : {-7.0, 0.0, 7.0}) {
            canvas.line({{x, 9}, {x, 7.8}}, Colour::dim, 2);
            canvas.lamp({x, 7.6}, 0.4, Colour::amber);
        }
        for (const double x : {-9.0, -3.0, 3.0, 9.0}) canvas.body(box({x - 0.3, -3.4}, {x + 0.3, -0.7}), Colour::wood);
        canvas.body(box({-11, -0.8}, {11, 0}), Colour::wood);
        for (int x = -10; x <= 10; ++x) canvas.line({{double(x), -0.3}, {double(x), 0}}, Colour::amber, 2);
        canvas.body(box({stop - 1.2, -0.06}, {stop + 1.2, 0.15}), Colour::violet);
        flag(canvas, {stop, 0}, number(stop, 2, "m"), Colour::violet, 5.2);
        canvas.arrow({0, aloft}, tip, Colour::orange, 4);
        canvas.trail(path, Colour::amber, 30).strength = 0.5;
        draw_glass(canvas, at);
        canvas.plate(at + Vec2{0, 4.2}, number(now.x(), 1, "m/s"), Colour::orange, 22);
    }
    static void draw_glass(Canvas &canvas, const Vec2 &at) {
        canvas.line(arc(at + Vec2{0.95, 1.5}, 0.6, -1.4, 1.4), Colour::ink, 7);
        canvas.body({at + Vec2{-0.8, 0.1}, at + Vec2{0.8, 0.1}, at + Vec2{0.95, 2.7}, at + Vec2{-0.95, 2.7}},
                    Colour::amber);
        canvas.balls({at + Vec2{-0.62, 2.8}, at + Vec2{0.62, 2.8}, at + Vec2{0, 3}}, 0.5, Colour::ink);
    }
};
} // namespace play
