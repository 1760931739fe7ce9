#pragma once
// The weight of a box has two parts: one presses it against its board, the other one pulls it down.
#include "shared.hpp"

namespace play {

struct Presses : BoardScene {
    static constexpr std::string_view name = "normal force (5.3)";
    double time = 0; ///< [s]

    Presses() {
        it.way = 1.4; // so that there's room for arrows
        still_time = 3;
    }

    void take_over() override { set_goal(flat); }
    double film() const override { return 22 - 12 * std::cos(1.2 * time); }
    void step(double dt) override { // nothing slides here
        time += dt;
        if (untouched) set_goal(film());
        angle_deg += std::clamp(goal_deg - angle_deg, -lift * dt, lift * dt);
    }

    void draw(Canvas &canvas) const override {
        constexpr double scale = 0.03; // so long is an arrow of 1 N [m]
        draw_board(canvas);
        draw_box(canvas);
        const double weight = box().mass * g, normal = normal_force(box().mass, angle(), g);
        const double pull = weight * along().y();
        const Vec2 at = middle(), out = turned(along());
        const Vec2 presses = at + scale * normal * out, pulls = at - scale * pull * along();
        canvas.arrow(at, at - Vec2{0, scale * weight}, Colour::ink, 4);
        canvas.arrow(at, presses, Colour::blue, 6);
        canvas.arrow(at, pulls, Colour::pink, 6);
        canvas.plate(presses + 0.6 * out, number(normal, 0, "N"), Colour::blue, 24);
        canvas.plate(pulls - 1.1 * along() + 0.3 * out, number(pull, 0, "N"), Colour::pink, 24);
        canvas.plate(at + Vec2{1.1, -0.6 * scale * weight}, number(weight, 0, "N"), Colour::ink, 20);
    }
};
} // namespace play
