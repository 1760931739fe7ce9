#pragma once
// The cannon aims itself: there are two angles, or none.
#include "shared.hpp"

namespace play {

struct Aims : CannonScene {
    static constexpr std::string_view name = "it aims (4.8)";
    Choice shot = choice("shot", {"the lower angle", "the higher angle"});
    Handle target = handle({40, 15}, {4, 0}, {94, 48});
    Button again = button("f", "Fire", [this] { shoot(); });
    double pointing = 20; ///< where the barrel points; where it did, when the target is out of reach [°]
    int hits = 0;
    double since_hit = 9; ///< [s]

    Aims() { still_time = 3.2; }

    double angle_deg() const override { return pointing; }
    double time_until_landing(const State &from) const override { return time_of_flight(from, g); }
    double target_width() const override { return 112; }
    std::vector<double> angles() const { return launch_angles(speed, target, g); }

    void drag() override { since_hit = 9; }
    void let_go() override { shoot(); }
    void changed() override { shoot(); }
    void shoot() {
        if (!angles().empty()) fire();
    }
    void step(double dt) override {
        constexpr double film[][2]{{30, 12}, {52, 4}, {24, 24}};
        if (untouched && !shell.flying && pause <= dt && hits > 0) target.move({film[hits % 3][0], film[hits % 3][1]});
        const std::vector<double> found = angles();
        if (!found.empty()) pointing = shot == 1 ? found.back() : found.front();
        else pause = 0.5; // out of reach, it waits
        since_hit += dt;
        CannonScene::step(dt);
        if (shell.flying && (shell.state.position - target.at()).norm() < 1.5) {
            shell.flying = false;
            spray.throw_from(target, {0, 14}, 1.2);
            ++hits;
            since_hit = 0;
        }
    }

    void draw(Canvas &canvas) const override {
        const Vec2 at = target;
        const std::vector<double> found = angles();
        for (const double each : found) {
            const State start = fired(height, each);
            std::vector<Vec2> way;
            for (int i = 0; i <= 24 && start.velocity.x() > 0; ++i)
                way.push_back(
                    motion::accelerated_motion(start, {0, -g}, i / 24.0 * at.x() / start.velocity.x()).position);
            canvas.dotted(std::move(way), each == pointing ? Colour::blue : Colour::dim, 3);
        }
        draw_cannon(canvas);
        canvas.bar({{at.x(), 0}, {at.x(), std::max(0.0, at.y() - 3)}}, Colour::wood, 4);
        for (const auto &[radius, colour] : {std::pair{3.0, Colour::pink}, {2.0, Colour::line}, {1.0, Colour::pink}})
            canvas.body(arc(at, radius), colour);
        draw_shell(canvas);
        if (found.empty()) canvas.plate(at + Vec2{0, 5}, "out of reach", Colour::pink, 24);
        else canvas.plate({9, height + 12}, number(pointing, 1) + "°", Colour::blue, 24);
        if (since_hit < 1) canvas.plate(at + Vec2{0, 5 + 4 * since_hit}, "hit", Colour::green, 26);
    }
};
} // namespace play
