#pragma once
// The logo of a DVD player. After a long frame it's far out, and the camera follows it.
#include "shared.hpp"

namespace play {

struct OnScreen : Scene {
    static constexpr std::string_view name = "a screen (6.1)";
    Button long_frame = button("l", "One long frame", [this] { skip(); });
    Ball logo{{5, 1.52}, {4, -3}, 1};
    int bounces = 0;
    double since[2]{9, 9}; ///< it was turned, left or right, and up or down [s]
    double wide = 18.2;    ///< of what's seen [m]
    std::vector<Vec2> path;

    OnScreen() { still_time = 2.6; }

    View view() const override {
        const Vec2 half{wide / 2, wide * 9 / 32};
        return {Vec2{8, 4.5} - half, Vec2{8, 4.5} + half, Stage::night};
    }
    /// Two seconds in which no side looks.
    void skip() {
        logo.position += 2 * logo.velocity;
        path.clear();
    }
    /// How far its edge is past a side [m].
    double out() const {
        const Vec2 edge{logo.radius, logo.radius};
        const Vec2 past = (screen.low - logo.position + edge).cwiseMax(logo.position + edge - screen.high);
        return std::max(past.maxCoeff(), 0.0);
    }
    void step(double dt) override {
        const Vec2 was = logo.velocity;
        next_frame(logo, screen, dt);
        for (const int k : {0, 1}) {
            since[k] += dt;
            if (logo.velocity[k] != was[k]) since[k] = 0, ++bounces;
        }
        path.push_back(logo.position);
        if (path.size() > 40) path.erase(path.begin());
        const Vec2 away = (logo.position - Vec2{8, 4.5}).cwiseAbs() + Vec2{1.6, 1.4};
        const double target = std::clamp(2 * std::max(away.x(), away.y() * 16 / 9), 18.2, 44.0);
        wide += std::min(1.0, 4 * dt) * (target - wide);
    }

    void draw(Canvas &canvas) const override {
        draw_television(canvas, screen, 0);
        canvas.trail(path, colour_of(bounces), 26).strength = 0.6;
        draw_logo(canvas, logo, bounces);
        if (out() < 0.3 && std::max(since[0], since[1]) < 1 && std::abs(since[0] - since[1]) < 0.1)
            canvas.plate({8, 4.3}, "into the corner!", Colour::amber, 30);
        const Vec2 label = (logo.position + Vec2{0, logo.position.y() > 4.5 ? -1.9 : 1.9})
                               .cwiseMax(view().low + Vec2{3, 1})
                               .cwiseMin(view().high - Vec2{3, 1});
        if (out() > 0.3) canvas.plate(label, number(out(), 1, "m out"), Colour::pink, 22);
    }
};
} // namespace play
