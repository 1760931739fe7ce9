#pragma once
// Two lines on squared paper, and what they have in common.
#include "shared.hpp"

namespace play {

struct Common : Scene {
    static constexpr std::string_view name = "two segments (7.3)";
    Handle ends[4]{end({1, 1}), end({7, 4}), end({9, 5}), end({3, 2})};
    double time = 0; ///< [s]

    Common() { still_time = 0.5; }

    Handle end(const Vec2 &at) { return handle(at, {0, 0}, {12, 6}); }
    View view() const override { return {{-0.6, -0.5}, {12.6, 6.925}, Stage::squared}; }
    void take_over() override { ends[1].move({7, 4}); }
    void drag() override {
        for (Handle &each : ends) each.move({std::round(each.at().x()), std::round(each.at().y())});
    }
    void
    step(double dt) override { // left alone, they share a piece, or nothing: a single point is the reader's to find
        time += dt;
        constexpr double film[][2]{{7, 4}, {9, 5}, {8, 2}, {5, 3}};
        const auto &[x, y] = film[int(time / 0.9) % 4];
        if (untouched) ends[1].move({x, y});
    }

    void draw(Canvas &canvas) const override {
        const std::vector<Vec2> both = common_points({ends[0], ends[1]}, {ends[2], ends[3]});
        if (both.size() > 1) canvas.line(both, Colour::amber, 26).strength = 0.7; // a marker's
        canvas.bar({ends[0], ends[1]}, Colour::blue, 6);
        canvas.bar({ends[2], ends[3]}, Colour::green, 6);
        canvas.balls({ends[0], ends[1]}, 0.17, Colour::blue);
        canvas.balls({ends[2], ends[3]}, 0.17, Colour::green);
        if (both.empty()) return;
        canvas.balls(both, 0.26, Colour::orange);
        canvas.plate((both.front() + both.back()) / 2 + Vec2{0, 1}, both.size() == 1 ? "one point" : "a piece",
                     Colour::orange, 24);
    }
};
} // namespace play
