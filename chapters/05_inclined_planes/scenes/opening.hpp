#pragma once
// At what angle does a box slip? Each mass leaves a pin at the protractor.
#include "shared.hpp"

namespace play {

struct Opening : BoardScene {
    static constexpr std::string_view name = "you guess";
    Choice mass = choice("mass", {"10 kg", "50 kg"});
    double pins[2]{-1, -1}; ///< where each of them slipped [°]
    double time = 0;        ///< [s]

    Opening() {
        lift = 12; // slowly, so that it's seen when it slips
        still_time = 2.2;
    }

    /// Up and down, but never so far that it slips: that's the reader's.
    double film() const override { return 15 - 5 * std::cos(1.5 * time); }
    bool heavy() const { return untouched ? int(1.5 * time / (2 * std::numbers::pi)) % 2 == 1 : mass == 1; }
    Box box() const override { return {heavy() ? 50.0 : 10.0, 0.5, 0.3}; }
    void changed() override { BoardScene::take_over(); }
    void slips() override { pins[heavy() ? 1 : 0] = angle_deg; }
    void step(double dt) override {
        time += dt;
        BoardScene::step(dt);
    }

    void draw(Canvas &canvas) const override {
        draw_board(canvas);
        for (const int i : {0, 1}) {
            if (pins[i] < 0) continue;
            const Vec2 at = foot + 9.5 * at_degrees(pins[i]);
            canvas.ball(at, 0.22, Colour::pink);
            canvas.plate(at + Vec2{2.1, i == 0 ? 0.5 : -0.5},
                         (i == 0 ? "10 kg: " : "50 kg: ") + number(pins[i], 0) + "°",
                         i == 0 ? Colour::blue : Colour::violet, 22);
        }
        draw_box(canvas);
        canvas.plate(middle(), number(box().mass, 0, "kg"), Colour::ink, 18);
    }
};
} // namespace play
