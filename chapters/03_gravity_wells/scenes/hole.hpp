#pragma once
// A ship that's held for two seconds, while its engine isn't. How few bursts keep it away?
#include "shared.hpp"

namespace play {

struct Hole : Space {
    static constexpr std::string_view name = "ship and hole (3.1)";
    static constexpr double held_for = 2, over_at = 8; // [s]
    Button up = button("ArrowUp", "Engine", [this] { burst_by({0, 1}); });
    int bursts = 0, flights = 0;

    Hole() { still_time = 3.6; }

    double widest() const override { return 64; }
    void begin() override {
        Space::begin();
        bursts = 0;
        ++flights;
    }
    void take_over() override { begin(); }
    void burst_by(const Vec2 &way) {
        if (fate != flying) return;
        burst_towards(ship.state.position + way);
        ++bursts;
    }
    void press(const Vec2 &at) override { burst_by(at - ship.state.position); }
    void fly(double dt) override {
        if (time > held_for) return Space::fly(dt);
        ship.state.velocity += dt / ship.mass * ship.thrust;
    }
    void step(double dt) override {
        const double before = time;
        Space::step(dt);
        for (int i = 0; i < (flights % 2 == 0 ? 1 : 3) && untouched; ++i) // one burst, then three
            if (const double when = 0.4 + 0.4 * i; before < when && time >= when) burst_by({0, 1});
        if (time > over_at || (untouched && time > 5.5)) begin();
    }

    void draw(Canvas &canvas) const override {
        const auto &[at, velocity] = ship.state;
        canvas.dotted(arc({0, 0}, 4), Colour::pink, 3);
        canvas.text({-0.6, -4.7}, "4 m", Colour::pink, 18);
        draw_hole(canvas, time);
        draw_path(canvas);
        draw_circle(canvas, nearest, 2.5, "nearest " + number(nearest, 1, "m"),
                    nearest > 4 ? Colour::green : Colour::pink);
        draw_ship(canvas);
        if (fate != flying) return;
        const Vec2 pull = gravity({at, 1}, hole, G);
        canvas.arrow(at, at + arrow * velocity, Colour::blue, 4);
        canvas.arrow(at, at + 0.15 * pull / std::max(1.0, pull.norm() / 40), Colour::green, 4);
        if (time < held_for) {
            const double left = 2 * std::numbers::pi * (1 - time / held_for);
            canvas.line(arc(at, 2.2, std::numbers::pi / 2 - left, std::numbers::pi / 2), Colour::amber, 5);
            canvas.plate(at + Vec2{5.2, 0}, "held", Colour::amber, 20);
        }
        canvas.plate({0.36 * wide, 0.23 * wide}, number(bursts, 0, bursts == 1 ? "burst" : "bursts"), Colour::amber,
                     26);
    }
};
} // namespace play
