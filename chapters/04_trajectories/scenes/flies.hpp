#pragma once
// A shell's velocity has two components. The game looks four times a second, and sees too late that it's in the ground.
#include "shared.hpp"

namespace play {

struct Flies : DialScene {
    static constexpr std::string_view name = "it flies (4.1)";
    int steps = 0;    ///< since the shot
    double depth = 0; ///< where it saw the shell, below the ground [m]

    Flies() { still_time = 3.5; }

    double time_until_landing(const State &) const override { return 100; }
    void step(double dt) override {
        CannonScene::step(dt);
        if (shell.time <= dt) steps = 0, depth = 0;
        if (++steps % 15 != 0 || !shell.flying || shell.state.position.y() >= 0) return;
        depth = -shell.state.position.y();
        shell.flying = false;
        spray.throw_from({shell.state.position.x(), 0}, {0, 12}, 0.6);
        pause = 2;
    }

    void draw(Canvas &canvas) const override {
        draw_cannon(canvas);
        draw_dial(canvas);
        draw_shell(canvas);
        const auto &[at, velocity] = shell.state;
        if (depth > 0) {
            canvas.line({{at.x() - 5, 0}, {at.x() + 5, 0}}, Colour::pink, 3);
            canvas.plate({at.x(), 3}, number(depth, 1, "m too deep"), Colour::pink);
        }
        if (!shell.flying) return;
        const double scale = 0.6; // so long is an arrow of 1 m/s [s]
        const Vec2 right{scale * velocity.x(), 0}, up{0, scale * velocity.y()};
        canvas.arrow(at, at + right, Colour::orange, 3);
        canvas.arrow(at, at + up, Colour::violet, 3);
        canvas.arrow(at, at + right + up, Colour::blue, 4);
        canvas.dotted({at + right, at + right + up, at + up}, Colour::dim, 2);
    }
};
} // namespace play
