#pragma once
// A cue ball into fifteen others: the reader aims.
#include "shared.hpp"

namespace play {

struct BreakShot : Scene {
    static constexpr std::string_view name = "break shot (8.3)";
    Slider restitution = slider("restitution", "", 0, 1, 0.1, 0.9);
    Handle tip = handle({-2, 0.2}, table.low, table.high);
    Button roll = button("f", "Roll", [this] { shoot(); });
    std::vector<Ball> balls;
    bool rolling = false;
    double since = 0; ///< it was racked up, or shot [s]
    double begun = 0; ///< the cue ball's kinetic energy [J]
    int shots = 0;    ///< that it has played by itself
    std::vector<Vec2> path;

    BreakShot() { still_time = 2.4; }

    View view() const override { return whole_table(); }
    /// The arrow; the cue ball's velocity is five times as much.
    Vec2 aim() const { return tip.at() - balls[0].position; }
    void rack_up() {
        balls = rack({1.5, 0}, {0, 0});
        rolling = false;
        since = 0;
        path.clear();
    }
    void shoot() {
        rack_up();
        rolling = true;
        balls[0].velocity = 5 * aim();
        begun = energy_of(balls[0]);
    }
    void begin() override { rack_up(); }
    void take_over() override { rack_up(); }
    void changed() override {
        if (rolling) shoot();
    }
    void drag() override {
        rack_up();
        tip.move(balls[0].position + aim() / std::max(1.0, aim().norm() / 2.5));
    }
    void step(double dt) override {
        since += dt;
        if (rolling) {
            next_frame(balls, table, restitution, dt);
            path.push_back(balls[0].position);
            if (path.size() > 40) path.erase(path.begin());
        }
        if (!untouched) return;
        constexpr double film[]{0.2, -0.15, 0.35}; // where it aims [m]
        if (!rolling) tip.move({-2, 0.2 + (film[shots % 3] - 0.2) * std::min(1.0, since / 0.5)});
        if (!rolling && since > 0.7) shoot();
        if (rolling && since > 6) ++shots, rack_up();
    }

    void draw(Canvas &canvas) const override {
        draw_table(canvas);
        if (path.size() > 1) canvas.trail(path, Colour::ink, 8).strength = 0.5;
        draw_balls(canvas, balls, Colour::ink,
                   {Colour::amber, Colour::orange, Colour::blue, Colour::violet, Colour::pink});
        if (!rolling) {
            const Vec2 at = balls[0].position, back = aim().norm() > 0.01 ? Vec2{-aim().normalized()} : Vec2{-1, 0};
            canvas.bar({at + (0.5 + 0.4 * aim().norm()) * back, at + 6 * back}, Colour::wood, 7);
            canvas.arrow(at, tip, Colour::orange, 4);
        } else if (!untouched)
            canvas.plate({0, 3.9}, number(std::abs(begun - energy_of(balls)), 1, "J lost"), Colour::amber, 22);
    }
};
} // namespace play
