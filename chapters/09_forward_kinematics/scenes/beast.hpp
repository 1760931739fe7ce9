#pragma once
// A beast with a long arm of many links, and two that are shorter.
#include "shared.hpp"

namespace play {

struct Beast : Scene {
    static constexpr std::string_view name = "tentacle (9.3)";
    Slider links = slider("links", "", 1, 40, 1, 20);
    Slider lag = slider("lag", "rad", 0, 1, 0.05, 0.25);
    double time = 0; ///< [s]

    Beast() { still_time = 1.6; }

    View view() const override { return {{-7.8, -1.2}, {7.8, 8}, Stage::night}; }
    void step(double dt) override { time += dt; }
    std::vector<Vec2> arm(double x, int count, double length, double later) const {
        return joints({x, 0}, tentacle(count, length, 8 * degree, lag, time + later));
    }

    void draw(Canvas &canvas) const override {
        const int count = int(links);
        for (const double side : {-2.4, 2.4}) canvas.bar(arm(side, (count + 1) / 2, 5, side), Colour::blue, 22);
        const std::vector<Vec2> all = arm(0, count, 7.5, 0);
        canvas.bar(all, Colour::green, 28);
        canvas.balls(all, 0.12, Colour::amber);
        canvas.body({{-4.6, -1.4}, {-4, -0.2}, {-2.1, 0.6}, {2.1, 0.6}, {4, -0.2}, {4.6, -1.4}}, Colour::violet);
        for (const double side : {-0.9, 0.9}) { // they look at the pointer, or at the tip
            const Vec2 eye{side, -0.25}, way = (hand.inside ? hand.at : all.back()) - eye;
            canvas.ball(eye, 0.55, Colour::ink);
            canvas.ball(eye + 0.25 / std::max(way.norm(), 0.25) * way, 0.26, Colour::violet);
        }
    }
};
} // namespace play
