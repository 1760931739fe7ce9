#pragma once
// How far does a shell fly? The flag is there before it's fired.
#include "shared.hpp"

namespace play {

struct Ranges : DialScene {
    static constexpr std::string_view name = "range (4.3)";
    Slider raised = slider("muzzle above the ground", "m", 0, 25, 5, 0);

    Ranges() { still_time = 2.6; }

    void begin() override {
        height = raised;
        CannonScene::begin();
    }
    void changed() override {
        if (height != raised) marks.clear();
        height = raised;
        fire();
    }
    void landed() override { remember(shell.state.position.x()); }

    void draw(Canvas &canvas) const override {
        draw_cannon(canvas);
        draw_dial(canvas);
        for (const Mark &mark : marks) canvas.line(mark.path, Colour::dim, 2).strength = 0.45;
        const double there = range(muzzle(), g);
        canvas.line({{0, -3}, {there, -3}}, Colour::violet, 3);
        flag(canvas, {there, 0}, number(there, 1, "m"), Colour::violet, 7, 26);
        draw_shell(canvas);
    }
};
} // namespace play
