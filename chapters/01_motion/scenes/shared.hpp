#pragma once
// A helicopter, a missile behind it, and the marks that they leave: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace motion;

/// It flies to the right, with its mast above this point.
/// @param size  from its nose to its tail
inline void draw_helicopter(Canvas &canvas, const Vec2 &at, double size, double time, Colour colour = Colour::blue) {
    const auto spot = [&](double x, double y) { return Vec2{at + size * Vec2{x, y}}; };
    canvas.line({spot(-0.2, -0.28), spot(0.3, -0.28)}, Colour::ink, 4);
    canvas.line({spot(-0.05, -0.28), spot(0, -0.1), spot(0.12, -0.28)}, Colour::ink, 3);
    canvas.body({spot(-0.64, 0.18), spot(-0.57, 0.2), spot(-0.5, 0.08), spot(0, 0.1), spot(0, -0.12), spot(-0.55, 0)},
                colour);
    std::vector<Vec2> cabin;
    for (const Vec2 &point : arc({0, 0}, 1)) cabin.push_back(spot(0.08 + 0.27 * point.x(), -0.03 + 0.18 * point.y()));
    canvas.body(std::move(cabin), colour);
    canvas.area({spot(0.14, 0.1), spot(0.25, 0.05), spot(0.31, -0.04), spot(0.14, -0.04)}, Colour::line);
    canvas.body({spot(0.02, 0.13), spot(0.06, 0.13), spot(0.06, 0.24), spot(0.02, 0.24)}, Colour::ink);
    const double wide = 0.08 + 0.44 * std::abs(std::cos(19 * time)); // as the rotor turns
    canvas.body({spot(0.04 - wide, 0.23), spot(0.04 + wide, 0.23), spot(0.04 + wide, 0.26), spot(0.04 - wide, 0.26)},
                Colour::dim);
    const Vec2 blade = 0.11 * size * Vec2{std::cos(23 * time), std::sin(23 * time)};
    canvas.line({spot(-0.6, 0.12) - blade, spot(-0.6, 0.12) + blade}, Colour::ink, 3);
}

/// A missile's hull, which is two thirds of it.
/// @param along  from the missile's tail to its tip
inline void draw_hull(Canvas &canvas, const Vec2 &tail, const Vec2 &along) {
    const Vec2 side = 0.1 * turned(along);
    canvas.body({tail - 0.08 * along + 2.4 * side, tail + 0.28 * along + side, tail + 0.28 * along - side,
                 tail - 0.08 * along - 2.4 * side, tail},
                Colour::ink);
    canvas.body({tail + side, tail + 0.66 * along + side, tail + 0.66 * along - side, tail - side}, Colour::orange);
}
/// The last third, from here on.
inline void draw_nose(Canvas &canvas, const Vec2 &base, const Vec2 &along) {
    const Vec2 side = 0.1 * turned(along);
    canvas.body({base + side, base + 0.2 * along + 0.65 * side, base + 0.34 * along, base + 0.2 * along - 0.65 * side,
                 base - side},
                Colour::pink);
}
/// @param at     its middle
/// @param flame  how strong its engine burns, up to 1
inline void draw_missile(Canvas &canvas, const Vec2 &at, const Vec2 &along, double flame, double time) {
    const Vec2 tail = at - 0.5 * along;
    if (flame > 0) canvas.beam({tail, tail - flame * (0.45 + 0.1 * std::sin(41 * time)) * along}, Colour::amber, 7);
    draw_hull(canvas, tail, along);
    draw_nose(canvas, tail + 0.66 * along, along);
}
} // namespace play
