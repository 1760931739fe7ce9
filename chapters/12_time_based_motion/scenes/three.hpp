#pragma once
// Three screens show one flight by dt. The outlines fly 2 px a frame, and each screen sees another flight.
#include "shared.hpp"

namespace play {

struct Three : Scene {
    static constexpr std::string_view name = "three screens (12.1)";
    static constexpr double wide = 640; ///< [px]
    Slider delay = slider("frame delay", "ms", 10, 700, 10, 100);
    std::array<Screen, 3> screens{};
    double naive[3]{}; ///< where a ship is that flies 2 px a frame [px]
    double time = 0;   ///< [s]

    void begin() override {
        time = 0;
        for (double &each : naive) each = 0;
        screens = {{{delay / 1000, 0, {0, cruise}}, {1.0 / 30, 0, {0, cruise}}, {1.0 / 144, 0, {0, cruise}}}};
    }
    View view() const override { return {{-34, -4}, {654, 383}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        if (time > wide / cruise) return begin();
        screens[0].frame = delay / 1000;
        const std::array<Screen, 3> before = screens;
        next_frames(screens, time);
        for (std::size_t i = 0; i < 3; ++i)
            naive[i] += 2 * std::round((screens[i].shown - before[i].shown) / before[i].frame);
    }

    void draw(Canvas &canvas) const override {
        constexpr Colour colours[]{Colour::orange, Colour::green, Colour::blue};
        for (std::size_t i = 0; i < 3; ++i) {
            const Screen &screen = screens[i];
            const double low = 258 - 128.0 * double(i), x = screen.ship.x;
            draw_screen(canvas, {-26, low}, {646, low + 118});
            canvas.text({-12, low + 99}, number(1 / screen.frame, screen.frame > 0.1 ? 1 : 0) + " frames a second",
                        Colour::ink, 18);
            canvas.plate({590, low + 97}, number(x, 0, "px"), colours[i], 20);
            if (naive[i] < wide) draw_ghost(canvas, {naive[i], low + 44}, 72, Colour::ink);
            draw_ship(canvas, {std::clamp(x, -1e4, 1e4), low + 44}, 72, colours[i], screen.shown);
        }
    }
};
} // namespace play
