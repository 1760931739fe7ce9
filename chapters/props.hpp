#pragma once
// Things that scenes of several chapters have in them.
#include "canvas.hpp"

namespace demo {

/// A quarter turn anticlockwise.
inline Vec2 turned(const Vec2 &v) { return {-v.y(), v.x()}; }

/// A gun on a wheel, 8 m long.
/// @param direction  of the barrel, a unit vector
inline void cannon(Canvas &canvas, const Vec2 &muzzle, const Vec2 &direction) {
    const Vec2 side = turned(direction), axle = muzzle - 5.5 * direction, breech = muzzle - 8 * direction;
    canvas.body({breech - 1.5 * side, muzzle - 1.0 * side, muzzle + 1.0 * side, breech + 1.5 * side}, Colour::ink);
    canvas.body({muzzle - 1.3 * side - 1.1 * direction, muzzle - 1.3 * side, muzzle + 1.3 * side,
                 muzzle + 1.3 * side - 1.1 * direction},
                Colour::ink);
    canvas.body(arc(axle, 2.6), Colour::wood);
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.5 + i * std::numbers::pi / 3;
        const Vec2 spoke = 2 * Vec2{std::cos(angle), std::sin(angle)};
        canvas.line({axle - spoke, axle + spoke}, Colour::earth, 3);
    }
    canvas.ball(axle, 0.8, Colour::amber);
}

/// A box of planks, with its lower left corner here.
inline void crate(Canvas &canvas, const Vec2 &low, double size) {
    canvas.body(box(low, low + Vec2{size, size}), Colour::wood);
    const double edge = 0.16 * size;
    canvas.line({low + Vec2{edge, edge}, low + Vec2{size - edge, size - edge}}, Colour::earth, 3);
    canvas.line({low + Vec2{edge, size - edge}, low + Vec2{size - edge, edge}}, Colour::earth, 3);
}

/// A pole with words on it, so high that neighbours can be told apart.
inline void flag(Canvas &canvas, const Vec2 &foot, const std::string &words, Colour colour, double height = 6,
                 double size = 22) {
    canvas.bar({foot, foot + Vec2{0, height}}, colour, 3);
    canvas.plate(foot + Vec2{0, height + 1}, words, colour, size);
}

/// A small spaceship.
/// @param at     its middle
/// @param ahead  where its nose points, a unit vector
/// @param flame  how strong its engine burns, up to 1
inline void ship(Canvas &canvas, const Vec2 &at, const Vec2 &ahead, double size, Colour colour, double flame = 0) {
    const auto spot = [&](double x, double y) { return Vec2{at + size * (x * ahead + y * turned(ahead))}; };
    if (flame > 0) canvas.beam({spot(-0.45, 0), spot(-0.45 - 0.6 * flame, 0)}, Colour::amber, 6);
    canvas.body({spot(0.5, 0), spot(-0.25, 0.32), spot(-0.55, 0.46), spot(-0.45, 0.15), spot(-0.45, -0.15),
                 spot(-0.55, -0.46), spot(-0.25, -0.32)},
                colour);
    canvas.ball(spot(0.05, 0), 0.12 * size, Colour::ink);
}
} // namespace demo
