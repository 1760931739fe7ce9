#pragma once
// How the hand moves while a joint turns: one arrow for each, and the area between them.
#include "shared.hpp"

namespace play {

struct Arrows : JointScene {
    static constexpr std::string_view name = "how the hand moves (9.5)";
    static constexpr double scale = 0.7; ///< so long is an arrow of 1 m/rad [rad]
    double time = 0;                     ///< [s]

    Arrows() : JointScene{{-7.2, -3.6}, {7.2, 4.5}, {1.2, -2.6}, {{3, 45 * degree}, {2, 60 * degree}}} {
        still_time = 1;
    }

    View view() const override { return {low, high, Stage::night}; }
    void step(double dt) override {
        if (!untouched) return;
        time += dt;
        set({70 + 50 * std::sin(1.6 * time), 50 + 25 * std::sin(2.3 * time)});
    }

    void draw(Canvas &canvas) const override {
        const std::vector<Vec2> all = joints(base, links), columns = jacobian(links);
        if (columns.size() < 2) return;
        const Vec2 from = all.back(), a = scale * columns[0], b = scale * columns[1];
        canvas.area({from, from + a, from + a + b, from + b}, Colour::amber).strength = 0.35;
        draw_foot(canvas, base, 1.3);
        steel_arm(canvas, all, Colour::dim, 20);
        canvas.arrow(from, from + a, Colour::pink, 5);
        canvas.arrow(from, from + b, Colour::green, 5);
        const double area = columns[0].x() * columns[1].y() - columns[0].y() * columns[1].x();
        label(canvas, from + a, a.normalized(), 1.3, "first joint", Colour::pink);
        label(canvas, from + b, std::copysign(1, area) * turned(b.normalized()), 0.95, "elbow", Colour::green);
        canvas.plate(base + Vec2{2.2, -0.4}, number(area, 1, "m²"), Colour::amber, 26);
    }
    /// Beside a point, that way, and in the picture.
    void label(Canvas &canvas, const Vec2 &at, const Vec2 &way, double wide, const char *words, Colour colour) const {
        const Vec2 beside = at + Vec2{wide * way.x(), 0.5 * way.y()}, rim{wide, 0.5};
        canvas.plate(beside.cwiseMax(low + rim).cwiseMin(high - rim), words, colour, 20);
    }
};
} // namespace play
