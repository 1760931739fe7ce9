#pragma once
// Carts of rubber, of any mass. Where does their point jump to?
#include "shared.hpp"

namespace play {

struct Rubber : PlaneScene {
    static constexpr std::string_view name = "rubber (2.2)";
    Slider m_a = slider("mass of A", "kg", 0.5, 10, 0.5, 2), m_b = slider("mass of B", "kg", 0.5, 10, 0.5, 3);

    Rubber() { still_time = 1.7; }

    double mass_of_a() const override { return m_a; }
    double mass_of_b() const override { return m_b; }
    void roll(double dt) override { next_frame(a, b, dt); }

    void draw(Canvas &canvas) const override { draw_with(canvas, velocities()); }
};
} // namespace play
