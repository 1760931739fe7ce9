#pragma once
// The arc before the shot: a dot for every fifth of a second.
#include "shared.hpp"

namespace play {

struct Dots : DialScene {
    static constexpr std::string_view name = "dotted arc (4.5)";

    Dots() { still_time = 2.8; }

    void draw(Canvas &canvas) const override {
        draw_crates(canvas);
        draw_cannon(canvas);
        canvas.dots(dotted_arc(muzzle(), g, 0.2), 0.75, Colour::blue);
        draw_dial(canvas);
        draw_shell(canvas);
    }
};
} // namespace play
