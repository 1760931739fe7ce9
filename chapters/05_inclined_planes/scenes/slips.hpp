#pragma once
// A block on a spring that sticks and slips; the camera goes with what pulls it. Above: its loop in phase space.
#include "shared.hpp"

namespace play {

struct Slips : Scene {
    static constexpr std::string_view name = "stick and slip (5.8)";
    Slider pulled_at = slider("pulled at", "m/s", 0.1, 1, 0.1, 0.2);
    Pulled it{0, 0, 0.3};
    double stuck = 0,
           stuck_last = -1; ///< for how long it has stuck now, and did the last time [s]; -1: it hasn't slipped
    std::vector<Vec2> loop; ///< stretch and velocity

    Slips() { still_time = 2.6; }

    View view() const override { return {{-8.6, -1.6}, {8.6, 8.075}, Stage::hills, 0}; }
    void changed() override {
        it = {0, 0, 0.3};
        stuck = 0;
        stuck_last = -1;
        loop.clear();
    }
    void step(double dt) override {
        for (int i = 0; i < 16; ++i) {
            it = stick_slip_step(it, block, {spring.stiffness, pulled_at}, g, dt / 16);
            if (it.velocity == 0) stuck += dt / 16;
            else if (stuck > 0) stuck_last = stuck_last < 0 ? 0 : stuck, stuck = 0;
        }
        loop.push_back({it.stretch, it.velocity});
        if (loop.size() > 400) loop.erase(loop.begin());
    }

    void draw(Canvas &canvas) const override {
        const double pulls = it.position + it.stretch; // stays where it is in the picture
        for (int i = -4; i <= 2; ++i) {
            const double mark = (std::floor(pulls) + i - pulls) * 6 + 4;
            canvas.body(box({mark - 0.1, -0.5}, {mark + 0.1, 0.35}), Colour::line);
        }
        const Vec2 at{0.2 - 6 * (it.stretch - 0.3), 0};
        draw_spring(canvas, at.x() + 0.9, 3.4);
        draw_tractor(canvas, {3.4, 0}, pulls);
        crate(canvas, at - Vec2{0.9, 0}, 1.8);
        if (it.velocity == 0) canvas.plate(at + Vec2{0, 2.5}, "sticks: " + number(stuck, 1, "s"), Colour::blue, 24);
        else canvas.plate(at + Vec2{0, 2.5}, "slips", Colour::orange, 24);
        if (stuck_last > 0) canvas.plate({4.9, 5.7}, "stuck for " + number(stuck_last, 2, "s"), Colour::blue, 24);
        draw_loop(canvas);
    }
    static void draw_spring(Canvas &canvas, double left, double right) {
        std::vector<Vec2> coil{{left, 0.9}};
        for (int i = 0; i <= 16; ++i)
            coil.push_back({left + 0.2 + (right - left - 0.4) * i / 16.0, i % 2 == 0 ? 0.6 : 1.2});
        coil.push_back({right, 0.9});
        canvas.bar(std::move(coil), Colour::dim, 4);
    }
    static void draw_tractor(Canvas &canvas, const Vec2 &at, double way) {
        canvas.body({at + Vec2{0, 0.5}, at + Vec2{3.2, 0.5}, at + Vec2{3.2, 1.5}, at + Vec2{1.5, 1.6},
                     at + Vec2{1.3, 2.7}, at + Vec2{0.2, 2.7}},
                    Colour::orange);
        canvas.bar({at + Vec2{2.7, 1.5}, at + Vec2{2.7, 2.4}}, Colour::ink, 6);
        for (const auto &[axle, radius] : {std::pair{at + Vec2{0.8, 0.9}, 0.9}, {at + Vec2{2.7, 0.5}, 0.5}}) {
            canvas.body(arc(axle, radius), Colour::ink);
            canvas.body(arc(axle, 0.5 * radius), Colour::amber);
            const double turn = -6 * way / radius;
            const Vec2 spoke = 0.5 * radius * Vec2{std::cos(turn), std::sin(turn)};
            canvas.line({axle - spoke, axle + spoke}, Colour::ink, 3);
        }
    }
    void draw_loop(Canvas &canvas) const {
        const auto seen = [](const Vec2 &point) { return Vec2{-7.4 + 11 * point.x(), 4.2 + 3.2 * point.y()}; };
        canvas.arrow(seen({0, 0}), seen({0.72, 0}), Colour::ink, 2);
        canvas.arrow(seen({0, 0}), seen({0, 1.1}), Colour::ink, 2);
        canvas.text(seen({0.74, -0.03}), "stretch", Colour::ink, 18);
        canvas.text(seen({0.03, 1.04}), "velocity", Colour::ink, 18);
        std::vector<Vec2> points;
        for (const Vec2 &point : loop) points.push_back(seen(point));
        canvas.line(std::move(points), Colour::orange, 4);
        canvas.ball(seen({it.stretch, it.velocity}), 0.25, Colour::orange);
    }
};
} // namespace play
