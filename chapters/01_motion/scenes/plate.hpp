#pragma once
// A plate with corners that can be dragged. Where does it balance, and where's the mean of its corners?
#include "shared.hpp"

namespace play {

struct Plate : Scene {
    static constexpr std::string_view name = "a plate (1.6)";
    Handle corners[6]{at(0, 0), at(3, 0), at(3, 1), at(1, 1), at(1, 3), at(0, 3)}; // [m]
    double time = 0;                                                               ///< [s]

    Plate() { still_time = 1.6; }

    Handle at(double x, double y) { return handle({x, y}, {-1.9, -0.4}, {5, 3.4}); }
    View view() const override { return {{-2, -0.5}, {5.11, 3.5}, Stage::felt}; }
    void take_over() override { corners[1].move({3, 0}); }
    void step(double dt) override {
        time += dt;
        if (untouched) corners[1].move(Vec2{3.4 - 0.4 * std::cos(time), 0.35 + 0.35 * std::sin(1.3 * time)});
    }

    void draw(Canvas &canvas) const override {
        std::vector<Vec2> points;
        Vec2 mean{0, 0};
        double area = 0; // signed [m²]
        for (int i = 0; i < 6; ++i) {
            const Vec2 p = corners[i], q = corners[(i + 1) % 6];
            points.push_back(p);
            mean += p / 6;
            area += (p.x() * q.y() - p.y() * q.x()) / 2;
        }
        canvas.body(points, Colour::wood);
        const bool balances = std::abs(area) > 1e-3; // all corners may be on one line
        const Vec2 middle = balances ? centroid(points) : mean;
        if (balances) canvas.ball(middle, 0.12, Colour::blue);
        for (const Vec2 &arm : {Vec2{0.13, 0.13}, {0.13, -0.13}}) canvas.bar({mean - arm, mean + arm}, Colour::pink, 5);
        const double up = mean.y() < middle.y() ? -0.46 : 0.46; // so that the words of both never meet [m]
        canvas.plate(middle - Vec2{0.9, up}, balances ? "centroid " + spot(middle) : "no area, no centroid",
                     Colour::blue, 18);
        canvas.plate(mean + Vec2{0.8, up}, "mean " + spot(mean), Colour::pink, 18);
    }
    static std::string spot(const Vec2 &at) { return "(" + number(at.x(), 2) + ", " + number(at.y(), 2) + ")"; }
};
} // namespace play
