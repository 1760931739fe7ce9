#pragma once
// Balls on a table: what the scenes of this chapter share.
#include "../../chance.hpp"
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

#include <initializer_list>

namespace play {
using namespace demo;
using namespace nt_collisions;

const Box table{{-8, -4.5}, {8, 4.5}};
const Colour colours[]{Colour::orange, Colour::blue}; ///< of A and B

inline double energy_of(const Ball &ball) { return ball.mass * ball.velocity.squaredNorm() / 2; }
inline double energy_of(const std::vector<Ball> &balls) {
    double sum = 0;
    for (const Ball &ball : balls) sum += energy_of(ball);
    return sum;
}

/// What's seen where the whole table is.
inline View whole_table() { return {{-9.6, -5.4}, {9.6, 5.4}, Stage::felt}; }

/// Cushions, and rails of wood with inlays.
inline void draw_table(Canvas &canvas) {
    rails(canvas, table.low, table.high, 0, 0.25, Colour::green);
    rails(canvas, table.low, table.high, 0.25, 0.6, Colour::wood);
    for (const double x : {-6, -4, -2, 2, 4, 6})
        for (const double y : {-5.05, 5.05}) canvas.dot({x, y}, 0.07, Colour::amber);
}

/// The angle between two directions [°].
inline double angle_between(const Vec2 &a, const Vec2 &b) { return std::abs(turn(a, b)) * 180 / std::numbers::pi; }

/// A ball with its letter on it, so far from its centre.
inline void draw_lettered(Canvas &canvas, const Vec2 &at, double radius, int which, const Vec2 &off = {0, 0}) {
    canvas.ball(at, radius, colours[which]);
    canvas.text(at + off - Vec2{0, 0.17}, which == 0 ? "A" : "B", Colour::ink, 22, Anchor::middle);
}
/// Where it will be, or was.
inline void draw_outline(Canvas &canvas, const Vec2 &at, double radius, Colour colour) {
    canvas.dotted(arc(at, radius), colour, 2);
}

/// The first one, and all others in turn in these colours.
inline void draw_balls(Canvas &canvas, const std::vector<Ball> &balls, Colour first,
                       std::initializer_list<Colour> others) {
    const std::vector<Vec2> centres = centres_of(balls);
    std::size_t which = 0;
    for (const Colour colour : others) {
        std::vector<Vec2> here;
        for (std::size_t i = 1 + which++; i < centres.size(); i += others.size()) here.push_back(centres[i]);
        canvas.balls(std::move(here), balls[0].radius, colour);
    }
    canvas.ball(centres[0], balls[0].radius, first);
}
} // namespace play
