#pragma once
// A television, and the logo on its screen.
#include "../../props.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace reflection;

inline Colour colour_of(int bounces) {
    constexpr Colour colours[]{Colour::amber, Colour::blue,   Colour::green,
                               Colour::pink,  Colour::orange, Colour::violet};
    return colours[bounces % 6];
}

/// Its screen is a box that's turned about the origin.
inline void draw_television(Canvas &canvas, const Box &box, double angle) {
    const Vec2 right = at_angle(angle), up = turned(right);
    for (int i = 1; i < 12; ++i) { // scan lines
        const double y = box.low.y() + i * (box.high.y() - box.low.y()) / 12;
        canvas.line({box.low.x() * right + y * up, box.high.x() * right + y * up}, Colour::blue, 2).strength = 0.2;
    }
    rails(canvas, box.low, box.high, 0, 0.14, Colour::ink, angle);
    rails(canvas, box.low, box.high, 0.14, 0.42, Colour::wood, angle);
}

inline void draw_logo(Canvas &canvas, const Ball &logo, int bounces) {
    canvas.lamp(logo.position, logo.radius, colour_of(bounces));
}
} // namespace play
