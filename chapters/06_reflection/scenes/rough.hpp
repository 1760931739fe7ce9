#pragma once
// A wall that gives back only a part of the normal speed, and takes some of the tangential one.
#include "shared.hpp"

namespace play {

struct Rough : TurningScene {
    static constexpr std::string_view name = "rough wall (6.4)";
    Slider restitution = slider("restitution", "", 0, 1, 0.1, 0.5);
    Slider mu_k = slider("mu_k", "", 0, 1, 0.1, 0.3);

    Surface surface() const { return {restitution, mu_k}; }
    Vec2 after(const Vec2 &normal) const override { return bounce(before, normal, surface()); }
    void move(double dt) override { next_frame(ball, {0, 0}, normal(), surface(), dt); }

    void draw(Canvas &canvas) const override {
        const Vec2 along = at_angle(angle_deg * degree), n = normal();
        draw_wall(canvas, -reach * along, reach * along);
        std::vector<Vec2> grains; // the rougher, the larger
        for (int i = -21; i <= 21; ++i) grains.push_back(0.2 * i * along - (0.06 + 0.03 * (i * i % 3)) * n);
        if (mu_k > 0) canvas.balls(std::move(grains), 0.04 + 0.09 * mu_k, Colour::amber);
        draw_angles(canvas, 1);
        draw_ball(canvas);
        if (met && (ball.position - meets()).norm() > 2.7)
            canvas.plate(ball.position + Vec2{0, 0.8}, number(ball.velocity.norm(), 1, "m/s"), Colour::ink, 20);
    }
};
} // namespace play
