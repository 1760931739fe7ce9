#pragma once
// Sparks bounce off a roof, and run down it.
#include "shared.hpp"

namespace play {

struct Walls : Show {
    static constexpr std::string_view name = "with walls (11.8)";
    Button again = button("x", "Burst", [this] { burst_at({15, 8}); });
    const std::vector<Wall> walls{{.start = {0, 0.3}, .end = {8, 0.3}}, {.start = {8, 0.3}, .end = {24, 6.1}}};

    Walls() : Show(200) { still_time = 1; }

    World world() const override { return {9, 0, width, height}; }
    void press(const Vec2 &place) override { burst_at(inside(place)); }
    void burst_at(const Vec2 &place) {
        since = 0;
        spawn(burst(at(place), disc_burst(random.many(160), 5), 2.4));
    }
    void begin() override { burst_at({17, 9}); }
    void step(double dt) override {
        time += dt;
        since += dt;
        for (auto &slot : pool)
            if (slot) slot = particles::step(*slot, world(), walls, dt);
        if (since > (untouched ? 1.5 : 4)) burst_at({13 + 6 * random.one(), 8 + 2 * random.one()});
    }

    void draw(Canvas &canvas) const override {
        canvas.body({{8, -1.1}, {8, 0.3}, {24.5, 6.3}, {24.5, -1.1}}, Colour::earth);
        for (const double left : {13.5, 16.5, 19.5})
            canvas.area(box({left, -0.2}, {left + 1.4, 1.4}), Colour::amber).strength = 0.75;
        canvas.body(box({-0.5, -1.4}, {8, 0.3}), Colour::line);
        canvas.bar({{-0.5, 0.15}, {8, 0.15}, {24.5, 6.13}}, Colour::wood, 9);
        draw_sparks(canvas, alive(), 0.27, 0.06);
    }
};
} // namespace play
