#pragma once
// Three frame loops fire one shell, and each point is the end of a frame. Which of them comes near the flag?
#include "shared.hpp"

namespace play {

struct Loops : CannonScene {
    static constexpr std::string_view name = "frame loops (4.9)";
    Slider rate = slider("frames per second", "", 2, 30, 1, 2);
    motion::Integrators all{};
    bool flies[3]{}; ///< explicit, semi-implicit, exact
    std::vector<Vec2> ends[3];

    Loops() { still_time = 3; }

    double angle_deg() const override { return 50; }
    double step_time() const override { return 1 / rate; }
    double target_width() const override { return 112; }

    void start() {
        all = {muzzle(), muzzle(), muzzle()};
        for (bool &each : flies) each = true;
        for (std::vector<Vec2> &each : ends) each = {muzzle().position};
        pause = 1.5;
    }
    void begin() override {
        CannonScene::begin();
        start();
    }
    void changed() override { start(); }
    void step(double dt) override {
        all = motion::step_all(all, {0, -g}, dt);
        const State *states[]{&all.explicit_euler, &all.semi_implicit, &all.exact};
        bool any = false;
        for (int i = 0; i < 3; ++i) {
            if (!flies[i]) continue;
            ends[i].push_back(states[i]->position);
            flies[i] = states[i]->position.y() > 0;
            any = true;
        }
        if (!any && (pause -= dt) <= 0) start();
    }

    void draw(Canvas &canvas) const override {
        constexpr Colour colours[]{Colour::orange, Colour::violet, Colour::blue};
        const LoopRanges there = frame_loop_ranges(muzzle(), g, step_time());
        const double far[]{there.explicit_euler, there.semi_implicit, there.exact}, right = range(muzzle(), g);
        const char *names[]{"explicit Euler", "semi-implicit Euler", "exact steps"};
        flag(canvas, {right, 0}, number(right, 1, "m"), Colour::ink, 20, 22);
        draw_cannon(canvas);
        for (int i = 0; i < 3; ++i) {
            canvas.line(ends[i], colours[i], 2).strength = 0.5;
            canvas.dots(ends[i], 0.6, colours[i]);
            canvas.balls({ends[i].back()}, 1.3, colours[i]);
            const std::string result = flies[i] ? "" : ": " + number(far[i], 1, "m");
            canvas.plate({14, 50 - 5.0 * i}, names[i] + result, colours[i], 18);
        }
    }
};
} // namespace play
