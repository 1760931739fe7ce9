#pragma once
// One ship by four integrators, which are swapped in flight. What becomes of its energy?
#include "shared.hpp"

namespace play {

struct FourIntegrators : Space {
    static constexpr std::string_view name = "four integrators (3.7)";
    Choice integrator = choice("integrator", {"explicit Euler", "semi-implicit Euler", "leapfrog", "Runge-Kutta"});
    Slider rate = slider("steps per second", "", 10, 120, 10, 60);
    Slider push = slider("push", "m/s", 0, 20, 0.5, 5);
    double pushed = 0, at_start = 0; ///< [m/s], and its energy then [J]

    FourIntegrators() { still_time = 3; }

    double widest() const override { return 100; }
    double step_time() const override { return 1 / rate; }
    State begins() const override { return {start, {0, push}}; }
    void begin() override {
        Space::begin();
        pushed = push;
        at_start = energy_of(ship.state);
    }
    void changed() override {
        if (push != pushed) begin(); // all others are changed in flight
    }
    void press(const Vec2 &at) override { burst_towards(at); }
    void fly(double dt) override {
        const State &now = ship.state;
        const Integrators after = step_all({now, now, now, now}, mu, dt);
        const State each[]{after.explicit_euler, after.semi_implicit, after.leapfrog, after.runge_kutta};
        ship.state = each[std::clamp(int(integrator), 0, 3)];
        ship.state.velocity += dt / ship.mass * ship.thrust;
    }

    void draw(Canvas &canvas) const override {
        draw_hole(canvas, time);
        draw_path(canvas);
        draw_ship(canvas);
        const double unit = wide / 39, left = 15.6 * unit, energy = energy_of(ship.state);
        const auto level = [&](double joules) { return unit * (9 + 0.17 * std::clamp(joules, -110.0, 5.0)); };
        canvas.bar({{left, level(-110)}, {left, level(5)}}, Colour::line, 16);
        canvas.beam({{left, level(-109)}, {left, level(energy)}}, Colour::amber, 9);
        canvas.line({{left - unit, level(at_start)}, {left + unit, level(at_start)}}, Colour::ink, 3);
        canvas.plate({left - 2.6 * unit, level(energy)}, number(energy, 0, "J"), Colour::amber, 22);
        canvas.text({19 * unit, -10.4 * unit}, "energy of each kg", Colour::amber, 16, Anchor::right);
    }
};
} // namespace play
