#pragma once
// One shot twice, with air and without. Leaves drift with the wind.
#include "../../chance.hpp"
#include "shared.hpp"

namespace play {

struct InAir : DialScene {
    static constexpr std::string_view name = "in air (4.10)";
    Slider drag = slider("drag", "1/m", 0, 0.1, 0.005, 0.025);
    Slider wind = slider("wind", "m/s", -30, 30, 1, 0);
    Shell free; ///< no air slows this one down
    std::vector<Vec2> leaves;
    double time = 0;

    InAir() { still_time = 4; }

    Air air() const { return {drag, {wind, 0}}; }
    double target_width() const override { return 92; }
    void start() {
        free.fire(muzzle(), time_of_flight(muzzle(), g));
        fire();
    }
    void begin() override {
        CannonScene::begin();
        for (int i = 0; i < 14; ++i)
            leaves.push_back({course::chance(2 * i, 4) * 92 - 12, 4 + course::chance(2 * i + 1, 4) * 34});
        start();
    }
    void changed() override {
        marks.clear();
        start();
    }
    void step(double dt) override {
        time += dt;
        for (Vec2 &leaf : leaves) leaf = {std::fmod(leaf.x() + dt * wind + 12 + 92, 92) - 12, leaf.y()};
        free.step(dt);
        if (shell.flying) {
            next_frame(shell.state, air(), dt);
            shell.time += dt;
            shell.path.push_back(shell.state.position);
            if (shell.state.position.y() <= 0) land();
        } else if (!free.flying && (pause -= dt) <= 0) start();
        spray.step(dt);
        smoke.step(dt);
    }
    void land() {
        shell.flying = false;
        shell.path.back() = shell.state.position = hit(shell.path.end()[-2], shell.path.back());
        spray.throw_from(shell.state.position, {0, 12}, 0.6);
        remember(shell.state.position.x());
    }

    void draw(Canvas &canvas) const override {
        draw_leaves(canvas);
        draw_cannon(canvas);
        draw_dial(canvas);
        canvas.dotted(free.whole(), Colour::dim, 2);
        canvas.balls({free.state.position}, 0.9, Colour::dim);
        if (!free.flying)
            flag(canvas, free.state.position, "no air: " + number(free.state.position.x(), 1, "m"), Colour::ink, 15,
                 20);
        for (const Mark &mark : marks) canvas.line(mark.path, Colour::orange, 2).strength = 0.5;
        draw_shell(canvas);
        if (!shell.flying && !marks.empty())
            flag(canvas, marks.back().at, number(marks.back().value, 1, "m"), Colour::violet, 7, 26);
        if (shell.flying)
            canvas.plate(shell.state.position + Vec2{0, 5}, number(shell.state.velocity.norm(), 0, "m/s"), Colour::ink,
                         18);
    }
    void draw_leaves(Canvas &canvas) const {
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const double angle = 1.5 * time * (wind < 0 ? 1 : -1) + double(i);
            const Vec2 along{std::cos(angle), 0.6 * std::sin(angle)},
                at = leaves[i] + Vec2{0, 0.5 * std::sin(2 * time + double(i))};
            canvas.line({at - 0.7 * along, at + 0.7 * along}, Colour::green, 4);
        }
    }
};
} // namespace play
