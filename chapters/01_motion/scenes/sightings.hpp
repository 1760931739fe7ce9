#pragma once
// Three sightings of a rocket, and the motion through them: time to the right, position upwards.
#include "shared.hpp"

namespace play {

struct Sightings : Scene {
    static constexpr std::string_view name = "three sightings (1.7)";
    static constexpr double second = 10; ///< so wide is a second [m]; a metre is a metre high
    Handle seen[3]{handle({10, 6}, {0, 0}, {58, 34}), handle({20, 11}, {1, 0}, {59, 34}),
                   handle({40, 27}, {2, 0}, {60, 34})};
    double time = 0; ///< of the sweep [s]
    double film = 0; ///< [s]

    Sightings() { still_time = 3; }

    View view() const override { return {{-9, -4}, {62, 36}, Stage::night}; }
    void step(double dt) override {
        film += dt;
        time = std::fmod(time + dt, 6.0);
        if (!untouched) return;
        seen[1].move({20, 10 + std::cos(film)});
        seen[2].move({40, 30 + 3 * std::sin(0.7 * film)});
    }
    void take_over() override {
        seen[1].move({20, 11});
        seen[2].move({40, 27});
    }
    /// They keep their order, a tenth of a second apart: two times are never equal.
    void drag() override {
        for (const int i : {0, 1})
            if (seen[i + 1].at().x() < seen[i].at().x() + 1)
                seen[i + 1].move({seen[i].at().x() + 1, seen[i + 1].at().y()});
    }

    void draw(Canvas &canvas) const override {
        const auto sample = [&](int i) { return Sample{seen[i].at().x() / second, seen[i].at().y()}; };
        const Motion found = fit_motion(sample(0), sample(1), sample(2));
        const auto height = [&](double t) { return found.x_0 + t * (found.v_0 + t * found.a / 2); };
        for (int k = 1; k <= 6; ++k) {
            canvas.line({{second * k, 0}, {second * k, 36}}, Colour::line, 1.5);
            canvas.text({second * k, -2}, number(k, 0, "s"), Colour::dim, 16, Anchor::middle);
        }
        for (const double x : {10, 20, 30}) {
            canvas.line({{0, x}, {62, x}}, Colour::line, 1.5);
            canvas.text({-0.6, x}, number(x, 0, "m"), Colour::dim, 16, Anchor::right);
        }
        canvas.line({{0, -1}, {0, 36}}, Colour::dim, 2);
        canvas.line({{-1, 0}, {62, 0}}, Colour::dim, 2);
        std::vector<Vec2> curve;
        for (int i = 0; i <= 62; ++i)
            if (const double x = height(0.1 * i); x > -4 && x < 40) curve.push_back({second * 0.1 * i, x});
        canvas.beam(std::move(curve), Colour::green, 3);
        const Vec2 now{second * time, height(time)};
        canvas.dotted({{-6.6, now.y()}, now}, Colour::amber, 2);
        canvas.ball(now, 0.9, Colour::amber);
        draw_missile(canvas, {-6.6, now.y()}, {0, found.v_0 + time * found.a < 0 ? -5.0 : 5.0}, 1, film);
        for (const Handle &each : seen) canvas.lamp(each, 1, Colour::amber);
        canvas.plate({14, 32}, number(found.a, 1, "m/s²"), Colour::green, 30);
        canvas.plate({14, 27.5}, "at 0 s: " + number(found.x_0, 1, "m, ") + number(found.v_0, 1, "m/s"), Colour::ink,
                     18);
    }
};
} // namespace play
