#pragma once
// Two machines have too much to do: one does all that's due, and one has a budget.
#include "shared.hpp"

namespace play {

struct Busy : Scene {
    static constexpr std::string_view name = "a busy machine (12.7)";
    static constexpr double high = 16; ///< a bar's height for a second of work [m/s]
    Slider cost = slider("cost of a step", "ms", 0.5, 20, 0.5, 4);
    /// What a machine is busy with: a hunter runs after a ball.
    struct Chase {
        Vec2 ball{1, 0.6}, speed{2.1, 1.5}, hunter{-1.5, -1}, heading{0, 0}; ///< [m], [m/s], [m], [m/s]
    };
    Machine machines[2]{};
    Chase chases[2]{};
    std::vector<double> works[2]{};  ///< how long the last frames worked [s]
    double time = 0, shown[2]{0, 0}; ///< [s]

    Busy() { still_time = 2.6; }

    void begin() override {
        for (Machine &machine : machines) machine = {}, machine.game.jobs = {{120, 0.004, 0}, {10, 0.005, 0}};
        for (int i = 0; i < 2; ++i) chases[i] = {}, works[i].clear(), shown[i] = 0;
        time = 0;
    }
    void take_over() override { begin(); }
    /// By itself it's busier and less busy, and never too much.
    double cost_ms() const { return untouched ? 5 - 2.5 * std::cos(2.4 * time) : double(cost); }
    View view() const override { return {{-5, -2.6}, {5, 3.025}, Stage::night}; }
    void step(double dt) override {
        if ((time += dt) > 3600) begin(); // a page that's left open: game time has a limit, too
        for (int i = 0; i < 2; ++i) {
            Machine &machine = machines[i];
            if (!machine.game.jobs.empty()) machine.game.jobs[0].cost = cost_ms() / 1000;
            while (shown[i] + machine.frame <= time + 1e-9) {
                shown[i] += machine.frame;
                next_frame(machine, i == 0 ? 1 : 1.0 / 60);
                for (const int job : machine.game.ran) run_job(chases[i], job);
                if (works[i].size() == 24) works[i].erase(works[i].begin());
                works[i].push_back(machine.work);
            }
        }
    }
    /// Job 0 moves both, 1 lets the hunter think.
    static void run_job(Chase &now, int job) {
        constexpr double step = 1.0 / 120;
        const Vec2 way = now.ball - now.hunter, field{1.9, 0.95}; // where the ball turns round [m]
        if (job == 1) now.heading = way.norm() > 0 ? Vec2{1.9 / way.norm() * way} : way;
        if (job != 0) return;
        now.ball += step * now.speed;
        now.hunter += step * now.heading;
        for (int axis = 0; axis < 2; ++axis)
            if (std::abs(now.ball[axis]) > field[axis])
                now.speed[axis] = now.ball[axis] > 0 ? -std::abs(now.speed[axis]) : std::abs(now.speed[axis]);
        if (way.norm() < 0.42) now.ball = -now.ball; // it gets away
    }

    void draw(Canvas &canvas) const override {
        for (int i = 0; i < 2; ++i) {
            const Machine &machine = machines[i];
            const Vec2 middle{i == 0 ? -2.45 : 2.45, 1.05}, ball = middle + chases[i].ball,
                                                            hunter = middle + chases[i].hunter;
            const Colour colour = i == 0 ? Colour::orange : Colour::blue;
            draw_screen(canvas, middle - Vec2{2.35, 1.4}, middle + Vec2{2.35, 1.4});
            canvas.ball(ball, 0.22, Colour::amber);
            canvas.ball(hunter, 0.36, colour);
            canvas.dot(hunter + 0.1 * chases[i].heading, 0.12, Colour::ink);
            canvas.text(middle + Vec2{0, 1.68}, i == 0 ? "all that's due" : "with a budget", colour, 20,
                        Anchor::middle);
            for (std::size_t k = 0; k < works[i].size(); ++k) { // 100 ms are as high as there's room
                const double work = works[i][k];
                const Vec2 foot{middle.x() - 2.3 + 0.193 * double(k), -2.0};
                canvas.body(box(foot, foot + Vec2{0.14, std::max(0.03, high * std::min(work, 0.1))}),
                            work > 1.0 / 60 + 1e-9 ? Colour::pink : Colour::green);
            }
            const double line = high / 60 - 2;
            canvas.dotted({{middle.x() - 2.35, line}, {middle.x() + 2.35, line}}, Colour::ink);
            canvas.plate({middle.x() + (i == 0 ? -1.0 : 1.0) * 1.3, -2.3}, number(1000 * machine.work, 0, "ms of work"),
                         colour, 18);
            canvas.plate({middle.x() + (i == 0 ? 1.0 : -1.0) * 1.25, -2.3}, "game " + number(machine.game.time, 1, "s"),
                         colour, 18);
        }
        canvas.readout("real time", time, "s", 1);
    }
};
} // namespace play
