#pragma once
// Twelve links, and one sweep a frame.
#include "shared.hpp"

namespace play {

struct Tentacle : FlyScene {
    static constexpr std::string_view name = "tentacle (10.6)";
    const Vec2 base{0, -3}; // [m]
    std::vector<Link> links = std::vector<Link>(12, Link{0.5, 0.12});

    Tentacle() : FlyScene{{-6.4, -3.6}, {6.4, 3.6}} {
        links[0].angle = 60 * degree;
        still_time = 1.6;
    }

    Vec2 wandering() const override { return {3.8 * std::sin(1.2 * time), 0.4 + 1.9 * std::sin(1.9 * time)}; }
    void react(double) override { next_frame(base, links, fly); }

    void draw(Canvas &canvas) const override {
        const std::vector<Vec2> all = joints(base, links);
        canvas.body({{-1.5, -3.9}, {1.5, -3.9}, {0.9, -2.9}, {-0.9, -2.9}}, Colour::earth);
        canvas.bar(all, Colour::green, 20);
        for (std::size_t i = 0; i < all.size(); ++i) canvas.ball(all[i], 0.42 - 0.02 * double(i), Colour::green);
        draw_fly(canvas);
        const double off = (all.back() - fly.at()).norm();
        if (off > 0.02) say(canvas, number(off, 2, "m"), Colour::pink);
    }
};
} // namespace play
