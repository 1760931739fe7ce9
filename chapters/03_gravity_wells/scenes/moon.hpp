#pragma once
// The Moon, and what falls onto it.
#include "../../props.hpp"

namespace play {
using namespace demo;

/// Its ground is at 0, with craters, for so much of it.
inline void draw_moon(Canvas &canvas, double left, double right) {
    canvas.lamp({left + 0.84 * (right - left), 14}, 1.5, Colour::blue); // the Earth
    canvas.body(box({left - 1, -5}, {right + 1, 0}), Colour::dim);
    const double first = std::floor(left / 7) - 1;
    for (int i = 0; i < 8; ++i) {
        const double k = first + i, wide = 1.2 + 0.5 * std::abs(std::fmod(5 * k, 3)),
                     y = -1.1 - 0.6 * std::abs(std::fmod(7 * k, 4));
        std::vector<Vec2> crater;
        for (const Vec2 &point : arc({0, 0}, 1))
            crater.push_back({7 * k + wide * point.x(), y + 0.24 * wide * point.y()});
        canvas.area(std::move(crater), Colour::line).strength = 0.6;
    }
}
/// On the ground, below something so high: the nearer, the smaller and the darker.
inline void draw_shadow(Canvas &canvas, double x, double height) {
    std::vector<Vec2> shadow;
    for (const Vec2 &point : arc({0, 0}, 1.1 + 0.08 * height))
        shadow.push_back({x + point.x(), -0.35 + 0.16 * point.y()});
    canvas.area(std::move(shadow), Colour::line).strength = std::max(0.15, 0.9 - 0.06 * height);
}
} // namespace play
