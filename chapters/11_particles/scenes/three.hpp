#pragma once
// Three sparks a press: how many slots are ever taken?
#include "shared.hpp"

namespace play {

struct Three : Show {
    static constexpr std::string_view name = "three sparks (11.3)";
    Button again = button("x", "Burst", [this] { throw_three({12, 2.2}); });
    std::size_t most = 0;

    Three() : Show(60) { still_time = 1.9; }

    World world() const override { return {5, 0.5, width, height}; }
    void press(const Vec2 &place) override { throw_three(inside(place)); }
    void throw_three(const Vec2 &place) {
        since = 0;
        spawn(three_sparks(place));
    }
    void begin() override { throw_three({12, 2.2}); }
    void take_over() override { most = 0; }
    void step(double dt) override {
        Show::step(dt);
        if (since > (untouched ? 0.8 : 4)) throw_three({12 + 5 * std::sin(2 * time), 2.2});
        most = std::max(most, alive().size());
    }

    void draw(Canvas &canvas) const override {
        draw_sparks(canvas, alive(), 0.7, 0.25, 1);
        draw_slots(canvas, taken(), -0.65, 60);
        canvas.plate({4.2, 1.2}, "at most " + number(double(most), 0), Colour::blue, 30);
    }
};
} // namespace play
