#pragma once
// Things that scenes of several chapters have in them.
#include "canvas.hpp"

namespace demo {

/// A quarter turn anticlockwise.
inline Vec2 turned(const Vec2 &v) { return {-v.y(), v.x()}; }

inline double direction_of(const Vec2 &v) { return std::atan2(v.y(), v.x()); }
/// From one direction to another [rad], positive if that's anticlockwise.
inline double turn(const Vec2 &from, const Vec2 &to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}
/// What lies between two directions.
inline void draw_angle(Canvas &canvas, const Vec2 &at, double radius, const Vec2 &from, const Vec2 &to,
                       Colour colour = Colour::amber) {
    const double first = direction_of(from), last = first + turn(from, to);
    canvas.area(sector(at, radius, first, last), colour).strength = 0.5;
    canvas.line(arc(at, radius, first, last), colour, 3);
}

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
/// @param right  along its lower side, a unit vector
inline void crate(Canvas &canvas, const Vec2 &low, double size, const Vec2 &right = {1, 0}) {
    const Vec2 along = size * right, up = turned(along), in = 0.16 * along, over = 0.16 * up;
    canvas.body({low, low + along, low + along + up, low + up}, Colour::wood);
    canvas.line({low + in + over, low + along - in + up - over}, Colour::earth, 3);
    canvas.line({low + in + up - over, low + along - in + over}, Colour::earth, 3);
}

/// Four rails round a table, so far away from it, with corners that are cut at 45°.
/// @param angle  by which all of that is turned about the origin [rad]
inline void rails(Canvas &canvas, const Vec2 &low, const Vec2 &high, double away, double width, Colour colour,
                  double angle = 0) {
    const Vec2 right{std::cos(angle), std::sin(angle)}, up = turned(right), middle = (low + high) / 2;
    const auto corner = [&](int i, double out) {
        const Vec2 sign{i % 4 == 1 || i % 4 == 2 ? 1.0 : -1.0, i % 4 >= 2 ? 1.0 : -1.0};
        const Vec2 at = middle + sign.cwiseProduct(high - middle + Vec2{out, out});
        return Vec2{at.x() * right + at.y() * up};
    };
    for (int i = 0; i < 4; ++i)
        canvas.body({corner(i, away), corner(i + 1, away), corner(i + 1, away + width), corner(i, away + width)},
                    colour);
}

/// A pole with words on it, so high that neighbours can be told apart.
inline void flag(Canvas &canvas, const Vec2 &foot, const std::string &words, Colour colour, double height = 6,
                 double size = 22) {
    canvas.bar({foot, foot + Vec2{0, height}}, colour, 3);
    canvas.plate(foot + Vec2{0, height + 1}, words, colour, size);
}

/// Links of steel from joint to joint, and a bolt in each joint [m].
inline void steel_arm(Canvas &canvas, const std::vector<Vec2> &joints, Colour colour, double width = 15,
                      double bolt = 0.17) {
    canvas.bar(joints, colour, width);
    canvas.balls(joints, bolt, Colour::ink);
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

/// Sparks where a ball has met something.
struct Knock {
    Vec2 at{0, 0}, out{0, 1};
    double age = 9; ///< [s]

    void draw(Canvas &canvas) const {
        if (age > 0.35) return;
        std::vector<Spark> all{{at, 0.35, 0.7 - 2 * age}};
        for (int i = -2; i <= 2; ++i)
            all.push_back({at + 4 * age * (out + 0.6 * i * turned(out)), 0.13, 1 - age / 0.35});
        canvas.sparks(all, Colour::amber);
    }
};
} // namespace demo
