#pragma once
// Two carts that roll through each other, until their reader has decided how they leave.
#include "shared.hpp"

namespace play {

struct Opening : Meeting {
    static constexpr std::string_view name = "you guess";
    static constexpr double second = 0.28; // so long is an arrow of 1 m/s [s]
    const Vec2 from_a{4, 3}, from_b{8, 3};
    Handle guess_a = handle(from_a + Vec2{1.12, 0}, from_a - Vec2{1.68, 0}, from_a + Vec2{1.68, 0});
    Handle guess_b = handle(from_b - Vec2{0.56, 0}, from_b - Vec2{1.68, 0}, from_b + Vec2{1.68, 0});
    int meetings = 0;

    Opening() { still_time = 1.6; }

    static double snapped(const Vec2 &arrow) { return std::round(10 * arrow.x() / second) / 10; }
    Velocities guess() const { return {snapped(guess_a.at() - from_a), snapped(guess_b.at() - from_b)}; }
    View view() const override { return {{1.8, -0.7}, {10.2, 4.025}, Stage::hills, -0.2}; }
    double start_of_a() const override { return 3; }
    double apart() const override { return 5; }
    double lasts() const override { return 2.4; }
    void begin() override {
        constexpr Velocities film[]{{4, -2}, {-2, 4}, {1, 1}};
        if (untouched) {
            const Velocities &now = film[meetings++ % 3];
            guess_a.move(from_a + Vec2{second * now.a, 0});
            guess_b.move(from_b + Vec2{second * now.b, 0});
        }
        Meeting::begin();
    }
    void drag() override { begin(); }
    void roll(double dt) override { roll_as_decided(dt, guess()); }

    void draw(Canvas &canvas) const override {
        draw_rail(canvas, 0, 0, 12);
        draw_guess(canvas, from_a, guess_a, "A after: ", guess().a, Colour::blue);
        draw_guess(canvas, from_b, guess_b, "B after: ", guess().b, Colour::green);
        draw_carts(canvas, true);
    }
    static void draw_guess(Canvas &canvas, const Vec2 &from, const Vec2 &tip, const char *whose, double velocity,
                           Colour colour) {
        canvas.line({from - Vec2{1.68, 0}, from + Vec2{1.68, 0}}, Colour::dim, 1.5).strength = 0.6;
        canvas.line({from - Vec2{0, 0.14}, from + Vec2{0, 0.14}}, Colour::dim, 2);
        canvas.arrow(from, tip, colour, 5);
        canvas.plate(from + Vec2{0, 0.5}, whose + number(velocity, 1, "m/s"), colour, 24);
    }
};
} // namespace play
