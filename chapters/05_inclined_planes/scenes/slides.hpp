#pragma once
// Static friction holds the box, or kinetic friction slows it down. At its sole both are seen.
#include "shared.hpp"

namespace play {

struct Slides : BoardScene {
    static constexpr std::string_view name = "it slides (5.4)";

    Slides() { still_time = 2.4; }

    double film() const override { return down() ? flat : 31; }

    void draw(Canvas &canvas) const override {
        draw_board(canvas);
        draw_box(canvas);
        if (down()) return;
        constexpr double scale = 0.05; // so long is an arrow of 1 N [m]
        const double pull = box().mass * g * along().y();
        const bool held = it.speed == 0 && incline_acceleration(box(), angle(), g) == 0;
        const double friction = held ? pull : friction_of(box(), angle()) * box().mass;
        const Vec2 sole = middle() - 0.5 * size() * turned(along());
        canvas.arrow(middle(), middle() - scale * pull * along(), Colour::pink, 6);
        canvas.arrow(sole, sole + scale * friction * along(), Colour::green, 6);
        const Vec2 above = middle() + 1.7 * turned(along());
        if (held) canvas.plate(above, "held", Colour::green, 22);
        else canvas.plate(above, number(it.speed, 1, "m/s"), friction > pull ? Colour::green : Colour::pink, 22);
    }
};
} // namespace play
