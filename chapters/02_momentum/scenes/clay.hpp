#pragma once
// From rubber to clay: how much of their energy do the carts lose?
#include "shared.hpp"

namespace play {

struct Clay : PlaneScene {
    static constexpr std::string_view name = "rubber to clay (2.3)";
    Slider m_a = slider("mass of A", "kg", 0.5, 10, 0.5, 2), m_b = slider("mass of B", "kg", 0.5, 10, 0.5, 3);
    Slider restitution = slider("restitution", "", 0, 1, 0.05, 1);

    Clay() { still_time = 1.7; }

    double mass_of_a() const override { return m_a; }
    double mass_of_b() const override { return m_b; }
    void roll(double dt) override { next_frame(a, b, restitution, dt); }

    void draw(Canvas &canvas) const override {
        draw_with(canvas, velocities());
        const auto &[v_a, v_b] = std::pair{velocities().x(), velocities().y()};
        const double energy = plane().energy, lost = energy - (m_a * v_a * v_a + m_b * v_b * v_b) / 2;
        if (met) canvas.plate({11.8, 4.3}, "lost " + number(100 * lost / energy, 0, "%"), Colour::pink, 22);
    }
};
} // namespace play
