#pragma once
// A lander comes down, frame by frame, and a press takes some of its fall. How fast does it hit the ground?
#include "shared.hpp"

namespace play {

struct Landing : Scene {
    static constexpr std::string_view name = "landing (3.3)";
    static constexpr double height = 12, drift = 1.6, burn = 1; // [m], [m/s], [m/s]
    Slider rate = slider("frames per second", "", 1, 60, 1, 4);
    Button press_it = button("ArrowUp", "Engine", [this] { fire(); });
    Fall lander{height, 0, 0};
    std::vector<Vec2> frames;                            ///< where it was in each [m]
    double time = 0, due = 0, since_burn = 9, pause = 0; ///< [s]
    int flights = 0;

    Landing() { still_time = 4; }

    Vec2 feet() const { return {drift * lander.time, lander.height}; }
    View view() const override {
        const double x = drift * lander.time, up = std::max(0.0, lander.height - height);
        return {{x - 17.3, up - 3}, {x + 17.3, up + 16.5}, Stage::moon};
    }
    void begin() override {
        lander = {height, 0, 0};
        frames = {feet()};
        time = due = pause = 0;
        ++flights;
    }
    void take_over() override { begin(); }
    void changed() override { begin(); }
    void press(const Vec2 &) override { fire(); }
    bool landed() const { return lander.height == 0; }
    void fire() {
        if (landed()) return;
        lander.velocity += burn;
        since_burn = 0;
    }
    void step(double dt) override {
        const double before = time;
        time += dt;
        since_burn += dt;
        for (int i = 0; i < flights % 3 && untouched; ++i) // none, one or two
            if (const double when = 1.2 + 0.7 * i; before < when && time >= when) fire();
        if (landed()) {
            if ((pause += dt) > 2) begin();
            return;
        }
        if ((due += dt) < 1 / rate - 1e-9) return;
        due -= 1 / rate;
        next_frame(lander, 0, 1 / rate);
        lander.height = std::max(lander.height, 0.0); // less is rounding
        frames.push_back(feet());
        if (frames.size() > 300) frames.erase(frames.begin());
    }

    void draw(Canvas &canvas) const override {
        const Vec2 at = feet();
        draw_shadow(canvas, at.x(), at.y());
        canvas.dots(frames, 0.17, Colour::amber);
        if (since_burn < 0.3) {
            canvas.beam({at + Vec2{0, 0.8}, at + Vec2{0, -1.4 + 4 * since_burn}}, Colour::amber, 12);
            draw_dust(canvas, at, since_burn);
        }
        draw_lander(canvas, at);
        const double speed = std::abs(lander.velocity);
        if (!landed()) {
            if (speed > 1)
                canvas.arrow(at + Vec2{2.6, 1.8}, at + Vec2{2.6, 1.8 + 0.5 * lander.velocity}, Colour::blue, 4);
            canvas.plate(at + Vec2{6.6, 1.8}, number(lander.velocity, 1, "m/s"), Colour::blue, 22);
        } else
            canvas.plate(at + Vec2{0, 5.2}, (speed < 2 ? "landed at " : "too fast: ") + number(speed, 1, "m/s"),
                         speed < 2 ? Colour::green : Colour::pink, 28);
    }
};
} // namespace play
