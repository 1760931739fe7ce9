#pragma once
// Screens, and what's seen on them: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace time_based_motion;

constexpr double finish = 800, cruise = 120; ///< [px], [px/s]

/// How many frames a screen shows until now, if each takes so long [s].
inline int frames_due(double &shown, double frame, double time) {
    int count = 0;
    for (; shown + frame <= time + 1e-9; shown += frame) ++count;
    return count;
}

/// A ship's nose is where it is.
inline void draw_ship(Canvas &canvas, const Vec2 &nose, double size, Colour colour, double time,
                      const Vec2 &ahead = {1, 0}) {
    ship(canvas, nose - 0.5 * size * ahead, ahead, size, colour, 0.55 + 0.3 * std::sin(41 * time));
}
/// Where it would be, or really is: its outline.
inline void draw_ghost(Canvas &canvas, const Vec2 &nose, double size, Colour colour, const Vec2 &ahead = {1, 0}) {
    const auto spot = [&](double x, double y) { return Vec2{nose + size * (x * ahead + y * turned(ahead))}; };
    canvas.line({spot(0, 0), spot(-0.75, 0.32), spot(-1.05, 0.46), spot(-0.95, 0.15), spot(-0.95, -0.15),
                 spot(-1.05, -0.46), spot(-0.75, -0.32), spot(0, 0)},
                colour, 2.5);
}

/// What a screen is set in.
inline void draw_screen(Canvas &canvas, const Vec2 &low, const Vec2 &high) {
    std::vector<Vec2> rim = box(low, high);
    canvas.area(rim, Colour::line).strength = 0.3;
    rim.push_back(low);
    canvas.bar(std::move(rim), Colour::dim, 4);
}

/// Two columns of a chequered line, so many fields high.
inline void draw_chequers(Canvas &canvas, const Vec2 &low, double side, int count) {
    for (int i = 0; i < count; ++i) {
        const Vec2 at = low + side * Vec2{double(i % 2), double(i)};
        canvas.area(box(at, at + Vec2{side, side}), Colour::ink).strength = 0.8;
    }
}

/// A small dinosaur; how far it ran says how its legs are.
inline void draw_runner(Canvas &canvas, const Vec2 &feet, double size, Colour colour, double ran) {
    constexpr double outline[][2]{{-62, 66}, {-36, 38}, {-14, 26}, {10, 30}, {22, 52}, {20, 76},  {44, 78},
                                  {46, 98},  {36, 104}, {6, 104},  {0, 96},  {-2, 70}, {-20, 58}, {-42, 56}};
    const auto spot = [&](double x, double y) { return Vec2{feet + size * Vec2{x, y}}; };
    const bool flies = feet.y() > 0;
    for (const double side : {1.0, -1.0}) {
        const double swing = side * (flies ? 0.12 : 0.24 * std::sin(4.2 * ran)) - 0.06;
        const double up = flies ? 0.06 : std::max(0.0, 0.1 * side * std::cos(4.2 * ran));
        canvas.bar({spot(-0.04, 0.36), spot(swing, up), spot(swing + 0.1, up)}, colour, 14 * size);
    }
    std::vector<Vec2> corners;
    for (const auto &[x, y] : outline) corners.push_back(spot(0.01 * x, 0.01 * y));
    canvas.body(std::move(corners), colour);
    canvas.bar({spot(0.16, 0.56), spot(0.34, 0.5)}, colour, 7 * size);
    canvas.dot(spot(0.18, 0.92), 0.05 * size, Colour::ink);
}
} // namespace play
