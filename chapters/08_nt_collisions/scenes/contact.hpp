#pragma once
// A touches B, which the reader moves around it; A's velocity is split into what's towards B and what's past it.
#include "shared.hpp"

namespace play {

struct Contact : Scene {
    static constexpr std::string_view name = "contact that turns (8.1)";
    static constexpr double scale = 0.7; ///< of the arrows [s]
    Handle other = handle({1.6, 1.2}, {-6.4, -3.6}, {6.4, 3.6}, Colour::blue);
    Handle tip = handle({3.5, 0}, {-6.4, -3.6}, {6.4, 3.6}, Colour::ink);
    double time = 0; ///< [s]

    View view() const override { return {{-6.4, -3.6}, {6.4, 3.6}, Stage::felt}; }
    /// From A's centre to B's.
    Vec2 n() const { return other.at().norm() > 0.01 ? Vec2{other.at().normalized()} : Vec2{1, 0}; }
    void drag() override { other.move(2 * n()); }
    void step(double dt) override {
        time += dt;
        const double angle = 0.75 - 0.45 * std::cos(1.7 * time); // never straight ahead, and never at a right angle
        if (untouched) other.move(2 * Vec2{std::cos(angle), std::sin(angle)});
    }

    void draw(Canvas &canvas) const override {
        const Vec2 to_b = n(), t = turned(to_b), velocity = tip.at() / scale;
        draw_lettered(canvas, {0, 0}, 1, 0, -0.5 * to_b);
        draw_lettered(canvas, 2 * to_b, 1, 1, 0.5 * to_b);
        draw_axis(canvas, to_b, "n");
        draw_axis(canvas, t, "t");
        const auto [normal, tangential] = arrows(velocity, {0, 0}, 2 * to_b);
        canvas.dotted({scale * normal, tip, scale * tangential}, Colour::ink);
        draw_part(canvas, scale * normal, Colour::pink);
        draw_part(canvas, scale * tangential, Colour::green);
        canvas.arrow({0, 0}, tip, Colour::ink, 4);
        if (untouched) return;
        const Components parts = decompose(velocity, {0, 0}, 2 * to_b);
        canvas.plate(scale * normal + (parts.normal < 0 ? -0.7 : 0.7) * to_b, number(parts.normal, 2, "m/s"),
                     Colour::pink, 22);
        canvas.plate(scale * tangential + (parts.tangential < 0 ? -0.5 : 0.5) * t, number(parts.tangential, 2, "m/s"),
                     Colour::green, 22);
    }
    static void draw_axis(Canvas &canvas, const Vec2 &along, const std::string &letter) {
        canvas.dotted({-9 * along, 9 * along}, Colour::ink, 1.5).strength = 0.6;
        canvas.text(-2.6 * along + 0.3 * turned(along) - Vec2{0, 0.15}, letter, Colour::ink, 20, Anchor::middle);
    }
    static void draw_part(Canvas &canvas, const Vec2 &to, Colour colour) {
        if (to.norm() > 0.02) canvas.arrow({0, 0}, to, colour, 7);
    }
};
} // namespace play
