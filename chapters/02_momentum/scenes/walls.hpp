#pragma once
// Two carts between two walls, and a stroke for each time that A hits B until B turns around.
#include "shared.hpp"

namespace play {

struct Walls : Scene {
    static constexpr std::string_view name = "between walls (2.5)";
    Slider mass_of_a = slider("mass of A", "kg", 0.5, 10, 0.5, 2);
    Slider mass_of_b = slider("mass of B", "kg", 0.5, 10, 0.5, 3);
    std::vector<RailBody> row; ///< wall, A, B, wall
    int hits = 0;
    bool turned = false;
    double time = 0; ///< [s]
    Clash clash;

    Walls() { still_time = 2.5; }

    View view() const override { return {{-0.6, -0.8}, {10.1, 5.21875}, Stage::hills, -0.2}; }
    void begin() override {
        row = {{0, {0, 0}}, {2, {1 / mass_of_a, before.a}}, {6.5, {1 / mass_of_b, before.b}}, {9.5, {0, 0}}};
        hits = 0;
        turned = false;
        time = 0;
    }
    void take_over() override { begin(); }
    void changed() override { begin(); }
    void press(const Vec2 &) override { begin(); }
    void step(double dt) override {
        time += dt;
        clash.age += dt;
        const double a = row[1].body.velocity, b = row[2].body.velocity;
        next_frame(row, 1, dt);
        if (row[1].body.velocity > a) clash = {{0.5, 0.32}, 0};
        if (row[2].body.velocity < b) clash = {{9, 0.32}, 0};
        if (row[2].body.velocity > b) { // only A pushes it to the right
            clash = {{(row[1].x + row[2].x) / 2, 0.32}, 0};
            if (!turned) ++hits;
            turned = turned || row[2].body.velocity > 0;
        }
        if (untouched && time > 8) begin();
    }

    void draw(Canvas &canvas) const override {
        const RailCart a{row[1].x, {mass_of_a, row[1].body.velocity}}, b{row[2].x, {mass_of_b, row[2].body.velocity}};
        draw_rail(canvas, 0, 0, 10);
        for (const double x : {-0.6, 9.0}) {
            canvas.body(box({x, -0.2}, {x + 1.1, 3.4}), Colour::earth);
            for (int i = 1; i < 9; ++i) canvas.line({{x, 0.4 * i - 0.2}, {x + 1.1, 0.4 * i - 0.2}}, Colour::wood, 2);
        }
        draw_cart(canvas, a, 0, Colour::blue, "A");
        draw_cart(canvas, b, 0, Colour::green, "B");
        clash.draw(canvas, 0.35);
        draw_velocity(canvas, a, 0, Colour::blue, -0.6);
        draw_velocity(canvas, b, 0, Colour::green, 0.6);
        const double momentum = a.cart.mass * a.cart.velocity + b.cart.mass * b.cart.velocity;
        canvas.plate({4.75, 4.7}, "momentum " + number(momentum, 1, "N s"), Colour::violet, 26);
        for (int i = 0; i < std::min(hits, 30); ++i) { // in fives
            const Vec2 foot{3.2 + 0.2 * i + 0.3 * (i / 5), 2.8};
            canvas.line({i % 5 == 4 ? foot + Vec2{-0.9, 0.15} : foot, foot + Vec2{0, 0.8}}, Colour::ink, 5);
        }
        if (turned)
            canvas.plate({4.75, 4}, number(hits, 0, hits == 1 ? "hit, and B turns" : "hits, and B turns"), Colour::ink,
                         22);
    }
};
} // namespace play
