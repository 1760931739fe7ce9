#pragma once
// Which push makes a circle? The arrow is the ship's velocity when it's let go.
#include "shared.hpp"

namespace play {

struct Opening : Space {
    static constexpr std::string_view name = "you guess";
    Handle tip = handle(start + Vec2{0, 2}, start, start + Vec2{0, 8});
    std::vector<Vec2> before; ///< the flight before this one
    int flights = 0;

    Opening() { still_time = 3.4; }

    double push() const { return std::round(2 * (tip.at().y() - start.y()) / arrow) / 2; } // [m/s]
    State begins() const override { return {start, {0, push()}}; }
    void begin() override {
        constexpr double film[]{5, 12, 7};
        if (untouched) tip.move(start + Vec2{0, arrow * film[flights++ % 3]});
        before = path;
        Space::begin();
    }
    void take_over() override { path.clear(); }
    void drag() override { Space::begin(); }
    void step(double dt) override {
        Space::step(dt);
        if (untouched && time > 4.2 && fate == flying) begin();
    }

    void draw(Canvas &canvas) const override {
        if (before.size() > 1) canvas.line(before, Colour::dim, 2).strength = 0.4;
        draw_hole(canvas, time);
        if (time > 0.3) {
            draw_circle(canvas, farthest, 2.2, "farthest " + number(farthest, 2, "m"), Colour::violet);
            draw_circle(canvas, nearest, -1.3, "nearest " + number(nearest, 2, "m"), Colour::green);
        }
        draw_path(canvas);
        canvas.arrow(start, tip, Colour::blue, 4);
        canvas.plate(tip.at() + Vec2{0.105 * wide, 0}, number(push(), 1, "m/s"), Colour::blue, 22);
        draw_ship(canvas);
    }
};
} // namespace play
