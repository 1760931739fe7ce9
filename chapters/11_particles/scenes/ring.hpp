#pragma once
// A ring beside a first try, in the wind.
#include "shared.hpp"

namespace play {

struct Ring : Show {
    static constexpr std::string_view name = "a ring (11.4)";
    Slider wind = slider("wind", "m/s²", -3, 3, 0.5, 0);
    Button again = button("x", "Burst", [this] { both(); });

    Ring() : Show(120) { still_time = 1.1; }

    World world() const override { return {4, wind, width, height}; }
    void both() {
        since = 0;
        for (auto &slot : pool) slot.reset();
        spawn(burst(at({6.6, 7.3}), box_burst(random, 60, 5), 1.05));
        spawn(burst(at({16.8, 7.3}), ring_burst(48, 5, 0), 1.05));
    }
    void press(const Vec2 &) override { both(); }
    void changed() override { both(); }
    void begin() override { both(); }
    void step(double dt) override {
        Show::step(0.6 * dt); // in slow motion
        if (since > 1.15) both();
    }

    void draw(Canvas &canvas) const override {
        const double light = std::max(0.0, 1 - since / 0.3);
        canvas.sparks({{{6.6, 7.3}, 1 + light, 0.5 * light}, {{16.8, 7.3}, 1 + light, 0.5 * light}}, Colour::amber);
        draw_sparks(canvas, alive(), 0.3, 0.12);
        canvas.text({6.6, -0.85}, "a first try", Colour::ink, 22, Anchor::middle);
        canvas.text({16.8, -0.85}, "your ring", Colour::ink, 22, Anchor::middle);
        if (wind != 0) canvas.arrow({12 - 0.6 * wind, 11.3}, {12 + 0.6 * wind, 11.3}, Colour::blue, 5);
    }
};
} // namespace play
