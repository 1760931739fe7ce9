#pragma once
// Carts on a rail, and two of them that meet: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace momentum;

constexpr Velocities before{4, -2}; // of the two carts that meet [m/s]

/// Its top is where the carts' wheels are.
inline void draw_rail(Canvas &canvas, double y, double from, double to) {
    for (double x = from; x < to; x += 1) canvas.body(box({x, y - 0.26}, {x + 0.35, y - 0.08}), Colour::earth);
    canvas.bar({{from - 1, y - 0.06}, {to + 1, y - 0.06}}, Colour::wood, 6);
}

/// So high is what a cart carries, a crate for each kilogram [m].
inline double load_height(double mass) { return 0.5 + 0.28 * std::ceil(std::ceil(mass) / 3); }

inline void draw_cart(Canvas &canvas, const RailCart &it, double y, Colour colour, const char *name) {
    const auto spot = [&](double x, double up) { return Vec2{it.x + x, y + up}; };
    const double left = std::min(it.cart.mass, 12.0);
    for (int i = 0; i < left; ++i) {
        const double size = left - i < 1 ? 0.14 : 0.27, row = std::min(3.0, std::ceil(left) - 3 * (i / 3));
        const Vec2 low = spot(0.28 * (i % 3 - row / 2), 0.48 + 0.28 * (i / 3));
        canvas.body(box(low, low + Vec2{size, size}), Colour::wood);
    }
    canvas.body(box(spot(-0.5, 0.26), spot(0.5, 0.38)), Colour::dim); // its bumpers
    canvas.body(box(spot(-0.44, 0.18), spot(0.44, 0.48)), colour);
    canvas.text(spot(0, 0.3), name, Colour::ink, 18, Anchor::middle);
    for (const double x : {-0.27, 0.27}) {
        const double angle = -it.x / 0.15;
        const Vec2 spoke = 0.11 * Vec2{std::cos(angle), std::sin(angle)};
        canvas.ball(spot(x, 0.14), 0.15, Colour::ink);
        canvas.line({spot(x, 0.14) - spoke, spot(x, 0.14) + spoke}, Colour::line, 2.5);
    }
}
/// Above a cart, as long as the way of 0.3 s, and how many metres a second it is, to its left or right.
inline void draw_velocity(Canvas &canvas, const RailCart &it, double y, Colour colour, double aside,
                          bool words = true) {
    const Vec2 from{it.x, y + load_height(it.cart.mass) + 0.2};
    const double velocity = it.cart.velocity;
    if (std::abs(velocity) > 0.05) canvas.arrow(from, from + Vec2{0.3 * velocity, 0}, colour, 4);
    if (words) canvas.plate(from + Vec2{aside, 0.4}, number(velocity, 1, "m/s"), colour, 22);
}

/// A flash where two things have met.
struct Clash {
    Vec2 at{0, 0};
    double age = 9; ///< [s]
    void draw(Canvas &canvas, double size) const {
        const double left = 1 - age / 0.3;
        if (left <= 0) return;
        canvas.lamp(at, size * (1.2 - left), Colour::amber).strength = left;
        for (int i = 0; i < 6; ++i) {
            const Vec2 way{std::cos(0.5 + i * 1.05), std::sin(0.5 + i * 1.05)};
            canvas
                .line({at + (0.8 - 0.5 * left) * size * 3 * way, at + (1.1 - 0.6 * left) * size * 3 * way},
                      Colour::amber, 3)
                .strength = left;
        }
    }
};

/// Two carts meet, and start again a while after that.
struct Meeting : Scene {
    RailCart a, b;
    bool met = false;
    double time = 0; ///< [s]
    Clash clash;

    virtual double mass_of_a() const { return 2; }
    virtual double mass_of_b() const { return 3; }
    virtual double start_of_a() const { return 2.4; }
    virtual double apart() const { return 7.1; }
    virtual double lasts() const { return 3; } // [s]
    /// They roll, and collide when they touch.
    virtual void roll(double dt) = 0;

    void begin() override {
        a = {start_of_a(), {mass_of_a(), before.a}};
        b = {start_of_a() + apart(), {mass_of_b(), before.b}};
        met = false;
        time = 0;
    }
    void changed() override { begin(); }
    void press(const Vec2 &) override { begin(); }
    void step(double dt) override {
        time += dt;
        clash.age += dt;
        roll(dt);
        if (!met && b.x - a.x <= cart_length) {
            met = true;
            clash = {{(a.x + b.x) / 2, 0.32}, 0};
        }
        if (time > lasts()) begin();
    }
    /// They leave with these velocities, right or wrong.
    void roll_as_decided(double dt, const Velocities &after) {
        for (RailCart *cart : {&a, &b}) cart->x += dt * cart->cart.velocity;
        if (!met && b.x - a.x <= cart_length) a.cart.velocity = after.a, b.cart.velocity = after.b;
    }
    void draw_carts(Canvas &canvas, bool words) const {
        draw_cart(canvas, a, 0, Colour::blue, "A");
        draw_cart(canvas, b, 0, Colour::green, "B");
        clash.draw(canvas, 0.35);
        draw_velocity(canvas, a, 0, Colour::blue, -0.6, words);
        draw_velocity(canvas, b, 0, Colour::green, 0.6, words);
    }
};
} // namespace play
