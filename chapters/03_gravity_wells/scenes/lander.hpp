#pragma once
// The Moon again, with an engine, jets, a pad and little fuel: land on one pad after the other.
#include "../../chance.hpp"
#include "shared.hpp"

namespace play {

struct Flight : Scene {
    static constexpr std::string_view name = "lander (3.9)";
    HeldKey left = held("left", "ArrowLeft"), engine = held("engine", "ArrowUp"), right = held("right", "ArrowRight");
    Lander lander;
    Controls controls;
    double pad = 0, time = 0, down_for = 0; ///< [m], [s], [s]
    unsigned flight = 0;
    int landings = 0, fuel_saved = 0; ///< in a row; what was left in all of these [s]

    Flight() { still_time = 3.4; }

    View view() const override { return {{0, -3}, {48, 24}, Stage::moon}; }
    void begin() override {
        const double before = flight == 0 ? 8 : pad;
        pad = 8 + 32 * course::chance(++flight, 1);
        if (std::abs(pad - before) < 10) pad = before < 24 ? before + 14 : before - 14;
        lander = {{{before, 16}, {0, 0}}, std::max(4.0, 9.0 - landings)};
        down_for = 0;
    }
    void take_over() override {
        landings = fuel_saved = 0;
        begin();
    }
    /// What a pilot does who brakes in time: a height and a speed to sink at, and a speed towards the pad.
    Controls autopilot() const {
        const auto &[at, velocity] = lander.state;
        const double way = pad - at.x(), wanted = std::clamp(0.45 * way, -4.0, 4.0) - velocity.x();
        const double sink = std::abs(way) > 3 ? 0.6 * (9 - at.y()) : -0.7 - 0.3 * at.y(); // [m/s]
        return {velocity.y() < sink, std::abs(wanted) < 0.1 ? 0 : wanted > 0 ? 1 : -1};
    }
    void step(double dt) override {
        time += dt;
        if (lander.landed || lander.crashed) {
            if ((down_for += dt) > 2) begin();
            return;
        }
        controls = untouched ? autopilot() : Controls{engine, int(right) - int(left)};
        next_frame(lander, controls, pad, dt);
        if (lander.landed) ++landings, fuel_saved += int(lander.fuel);
        if (lander.crashed) landings = fuel_saved = 0;
    }

    void draw(Canvas &canvas) const override {
        const auto &[at, velocity] = lander.state;
        const bool burns = controls.engine && lander.fuel > 0, flies = !lander.landed && !lander.crashed;
        canvas.bar({{pad - half_pad, 0}, {pad + half_pad, 0}}, Colour::green, 10);
        for (const double side : {-1.0, 1.0}) canvas.lamp({pad + side * half_pad, 0.3}, 0.25, Colour::green);
        draw_shadow(canvas, at.x(), at.y());
        if (flies && burns) {
            canvas.beam({at + Vec2{0, 0.8}, at + Vec2{0, -1.4 + 0.3 * std::sin(40 * time)}}, Colour::amber, 12);
            draw_dust(canvas, at, 0.1);
        }
        if (flies && controls.jets != 0)
            canvas.beam({at + Vec2{-0.9 * controls.jets, 2.6}, at + Vec2{-2 * controls.jets, 2.6}}, Colour::blue, 5);
        if (lander.crashed && down_for < 1)
            for (int i = 0; i < 16; ++i)
                canvas.lamp(at + (1 + i % 3) * 3 * down_for * Vec2{std::cos(0.41 * i), std::sin(0.2 * i)}, 0.5,
                            Colour::orange);
        else if (!lander.crashed) draw_lander(canvas, at);
        canvas.bar({at + Vec2{-2, 4.4}, at + Vec2{-2 + 4 * lander.fuel / 9, 4.4}}, Colour::blue, 7); // what's left
        const double speed = velocity.norm();
        const Vec2 above{std::clamp(at.x(), 5.0, 43.0), at.y() + 5.8};
        if (flies) canvas.plate(above, number(speed, 1, "m/s"), speed <= soft ? Colour::green : Colour::pink, 20);
        else if (lander.landed) canvas.plate(above, "landed at " + number(speed, 1, "m/s"), Colour::green, 24);
        else
            canvas.plate(above, speed > soft ? "too fast: " + number(speed, 1, "m/s") : "beside the pad", Colour::pink,
                         24);
        if (landings > 0)
            canvas.plate({24, 22},
                         std::to_string(landings) + " in a row, " + std::to_string(fuel_saved) + " s of fuel saved",
                         Colour::ink, 22);
    }
};
} // namespace play
