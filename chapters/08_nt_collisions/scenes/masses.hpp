#pragma once
// Two balls with masses: what they have of momentum and kinetic energy, before and after.
#include "off_centre.hpp"

namespace play {

struct Masses : OffCentre {
    static constexpr std::string_view name = "masses (8.3)";
    Slider mass_of_a = slider("mass of A", "kg", 0.5, 10, 0.5, 2);
    Slider mass_of_b = slider("mass of B", "kg", 0.5, 10, 0.5, 3);
    Slider restitution = slider("restitution", "", 0, 1, 0.1, 0.9);
    double begun = 0;    ///< the kinetic energy at the beginning [J]
    double momentum = 1; ///< of both at the beginning, without their directions [N s]

    Masses() { still_time = 1.7; }

    void start() override {
        const auto ball = [](double mass, double speed) {
            return Ball{{0, 0}, {speed, 0}, 0.42 * std::cbrt(mass), mass};
        };
        meet(ball(mass_of_a, 5), ball(mass_of_b, speed_of_b));
        begun = energy_of(a) + energy_of(b);
        momentum = a.mass * a.velocity.norm() + b.mass * b.velocity.norm();
    }
    void move(double dt) override { collide_and_roll(restitution, dt); }

    void draw(Canvas &canvas) const override {
        draw_both(canvas);
        draw_momentum(canvas);
        const double energy = energy_of(a) + energy_of(b);
        const Vec2 sum = a.mass * a.velocity + b.mass * b.velocity;
        // without a last bit's rounding, and without a negative zero
        const auto tidy = [](double value) { return std::round(value * 1e6) / 1e6 + 0.0; };
        canvas.readout("momentum, to the right", tidy(sum.x()), "N s");
        canvas.readout("momentum, up", tidy(sum.y()), "N s");
        canvas.readout("kinetic energy", tidy(energy), "J");
        canvas.readout("lost", tidy(begun - energy), "J");
    }
    /// A's momentum, and B's from its tip; at the end of both is their sum.
    void draw_momentum(Canvas &canvas) const {
        const double scale = 2 / momentum; // [m/(N s)]
        const Vec2 foot{-4.2, 1.7}, first = foot + scale * a.mass * a.velocity;
        const Vec2 sum = first + scale * b.mass * b.velocity;
        canvas.text({-6, 3.1}, "momentum", Colour::ink, 18);
        canvas.dotted({foot, sum}, Colour::ink, 2);
        if ((first - foot).norm() > 0.02) canvas.arrow(foot, first, colours[0], 5);
        if ((sum - first).norm() > 0.02) canvas.arrow(first, sum, colours[1], 5);
        canvas.dot(sum, 0.1, Colour::amber);
    }
};
} // namespace play
