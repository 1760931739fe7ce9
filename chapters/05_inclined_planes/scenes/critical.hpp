#pragma once
// The steepest angle that still holds the box, for a board that is as rough as the reader wants.
#include "shared.hpp"

namespace play {

struct Critical : BoardScene {
    static constexpr std::string_view name = "critical angle (5.5)";
    Slider mu_s = slider("mu_s", "", 0.1, 2, 0.1, 0.5);

    Critical() {
        lift = 20;
        still_time = 1.6;
    }

    double film() const override { return down() ? flat : it.speed > 0 ? goal_deg : std::min(angle_deg + 3, 70.0); }
    Box box() const override { return {10, mu_s, 0.6 * mu_s}; }
    void changed() override { BoardScene::take_over(); }

    void draw(Canvas &canvas) const override {
        const double there = critical_angle(mu_s);
        const Vec2 way{std::cos(there), std::sin(there)};
        canvas.beam({foot, foot + 9.5 * way}, Colour::violet, 2);
        draw_board(canvas);
        canvas.plate((foot + 10.9 * way).cwiseMin(view().high - Vec2{1.2, 0.75}), number(there / degree, 1) + "°",
                     Colour::violet, 24);
        std::vector<Vec2> grains; // the rougher, the larger
        for (int i = 1; i < 30; ++i) grains.push_back(foot + 0.3 * i * along());
        canvas.balls(std::move(grains), 0.02 + 0.06 * mu_s, Colour::earth);
        draw_box(canvas);
    }
};
} // namespace play
