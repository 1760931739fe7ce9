#pragma once
// Where is a shell highest? Each angle that the dial has had leaves its highest point.
#include "shared.hpp"

namespace play {

struct Apexes : DialScene {
    static constexpr std::string_view name = "apex (4.4)";
    std::vector<Vec2> tops =
        std::vector<Vec2>(46, Vec2{0, -100}); ///< for every third angle; those below are not yet there

    Apexes() {
        height = cliff;
        still_time = 2.2;
    }

    void step(double dt) override {
        tops[std::size_t(std::lround((angle_deg() + 45) / 3))] = apex(muzzle(), g);
        DialScene::step(dt);
    }
    double target_width() const override { return 124; }

    void draw(Canvas &canvas) const override {
        draw_cannon(canvas);
        draw_dial(canvas);
        std::vector<Vec2> seen;
        for (const Vec2 &top : tops)
            if (top.y() > -50) seen.push_back(top);
        canvas.dots(std::move(seen), 0.7, Colour::green);
        const Vec2 top = apex(muzzle(), g);
        canvas.dotted({{top.x(), 0}, top}, Colour::green, 3);
        draw_shell(canvas);
        canvas.ball(top, 1.3, Colour::green);
        canvas.plate(top + Vec2{10, -1}, number(top.y(), 1, "m"), Colour::green, 24);
    }
};
} // namespace play
