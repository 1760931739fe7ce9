#pragma once
// One missile by three integrators: how far are both Eulers from the exact one after two seconds?
#include "shared.hpp"

namespace play {

struct Three : Scene {
    static constexpr std::string_view name = "three integrators (1.5)";
    Slider length = slider("step", "s", 0.05, 1, 0.05, 0.5);
    const motion::State start{{20, 0}, {120, 0}}; // [px], [px/s]
    Integrators now{start, start, start};
    std::vector<double> ends[3];                    ///< of the steps: explicit, semi-implicit, exact [px]
    double time = 0, due = 0, flown = 0, pause = 0; ///< [s]

    Three() { still_time = 2.9; }

    View view() const override { return {{-86, 0}, {606, 389}, Stage::hills, 30}; }
    void begin() override {
        now = {start, start, start};
        for (std::vector<double> &each : ends) each = {start.position.x()};
        due = flown = pause = 0;
    }
    void changed() override { begin(); }
    bool over() const { return flown + length > 2.001; }
    void step(double dt) override {
        time += dt;
        if (over()) {
            if ((pause += dt) > 2) begin();
            return;
        }
        if ((due += dt) < length - 1e-9) return;
        due -= length;
        flown += length;
        now = step_all(now, {100, 0}, length);
        ends[0].push_back(now.explicit_euler.position.x());
        ends[1].push_back(now.semi_implicit.position.x());
        ends[2].push_back(now.exact.position.x());
    }

    void draw(Canvas &canvas) const override {
        constexpr Colour colours[]{Colour::pink, Colour::violet, Colour::blue};
        constexpr double heights[]{86, 296, 191};
        const char *names[]{"explicit Euler", "semi-implicit Euler", "exact"};
        const double right = ends[2].back();
        canvas.dotted({{right, 45}, {right, 335}}, Colour::blue, 3);
        for (int i = 0; i < 3; ++i) {
            std::vector<Vec2> marks;
            for (const double x : ends[i]) marks.push_back({x, heights[i]});
            const Vec2 at = marks.back();
            canvas.dots(std::move(marks), 4, colours[i]);
            draw_missile(canvas, at - Vec2{45, 0}, {90, 0}, over() ? 0 : 1, time);
            canvas.text({-76, heights[i] + 38}, names[i], colours[i], 20);
            if (i == 2 || flown == 0) continue;
            canvas.line({{right, at.y() - 26}, {at.x(), at.y() - 26}}, colours[i], 6);
            canvas.plate({std::min((at.x() + right) / 2, 510.0), at.y() - 50},
                         number(std::abs(at.x() - right), 0, at.x() < right ? "px behind" : "px ahead"), colours[i],
                         20);
        }
    }
};
} // namespace play
