#pragma once
// A comet that Kepler's equation moves, and two areas that it sweeps in the same time.
#include "shared.hpp"

namespace play {

struct Kepler : Scene {
    static constexpr std::string_view name = "Kepler (3.8)";
    static constexpr double semi_major = 8; // [m]
    Slider eccentricity = slider("eccentricity", "", 0, 0.95, 0.05, 0.5);
    double part = 0; ///< of a turn

    Kepler() { still_time = 2; }

    View view() const override { return {{-16, -9}, {16, 9}, Stage::night}; }
    static double turn() { return 2 * std::numbers::pi * std::sqrt(semi_major * semi_major * semi_major / mu); } // [s]
    void step(double dt) override { part = std::fmod(part + dt / turn(), 1.0); }

    void draw(Canvas &canvas) const override {
        const Vec2 sun{eccentricity * semi_major, 0}; // so that the ellipse is in the middle
        const auto at = [&](double of_turn) -> Vec2 {
            return kepler_position(semi_major, eccentricity, mu, of_turn * turn()) + sun;
        };
        for (const int k : {0, 6}) { // from one mark to the next
            std::vector<Vec2> swept{sun};
            for (int i = 0; i <= 8; ++i) swept.push_back(at((k + i / 8.0) / 12));
            canvas.area(std::move(swept), Colour::green).strength = 0.45;
        }
        std::vector<Vec2> orbit, marks;
        for (int k = 0; k <= 72; ++k) orbit.push_back(at(k / 72.0));
        for (int k = 0; k < 12; ++k) marks.push_back(at(k / 12.0));
        canvas.line(std::move(orbit), Colour::blue, 2);
        canvas.dots(std::move(marks), 0.24, Colour::dim);
        canvas.lamp(sun, 0.7, Colour::amber);
        draw_comet(canvas, at(part), sun);
    }
    /// Its tail is blown away from the Sun, the longer the nearer it is.
    static void draw_comet(Canvas &canvas, const Vec2 &at, const Vec2 &sun) {
        const Vec2 away = at - sun;
        const double r = std::max(away.norm(), 0.1), length = 30 / (r + 2);
        std::vector<Spark> tail;
        for (int i = 0; i < 14; ++i)
            tail.push_back({at + length * i / 14 / r * away, 0.3 - 0.012 * i, 0.45 - 0.03 * i});
        canvas.sparks(tail, Colour::blue);
        canvas.ball(at, 0.4, Colour::orange);
    }
};
} // namespace play
