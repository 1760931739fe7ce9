#pragma once
// What lies on the table, and around it, seen from above.
#include "../../canvas.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace table_hockey;
using table_hockey::Player;

/// A digit as an old scoreboard shows it: seven bars, of which some are lit.
inline void draw_digit(Canvas &canvas, const Vec2 &middle, int digit, Colour colour) {
    constexpr unsigned char lit[]{0x77, 0x24, 0x5d, 0x6d, 0x2e, 0x6b, 0x7b, 0x25, 0x7f, 0x6f};
    const Vec2 ends[][2]{{{-1, 2}, {1, 2}},   {{-1, 2}, {-1, 0}}, {{1, 2}, {1, 0}},   {{-1, 0}, {1, 0}},
                         {{-1, 0}, {-1, -2}}, {{1, 0}, {1, -2}},  {{-1, -2}, {1, -2}}};
    for (int bar = 0; bar < 7; ++bar) {
        const Vec2 from = middle + 0.034 * ends[bar][0], to = middle + 0.034 * ends[bar][1], gap = 0.15 * (to - from);
        if (lit[digit] >> bar & 1) canvas.beam({from + gap, to - gap}, colour, 5);
        else canvas.line({from + gap, to - gap}, colour).strength = 0.15;
    }
}
inline void draw_score(Canvas &canvas, double x, int goals, Colour colour) {
    const int shown = std::clamp(goals, 0, 99);
    if (shown > 9) draw_digit(canvas, {x - 0.13, 0.735}, shown / 10, colour);
    draw_digit(canvas, {x, 0.735}, shown % 10, colour);
}

/// Wood around the cloth, with a gap for each goal.
inline void draw_frame(Canvas &canvas) {
    constexpr double x = half_length, y = half_width, near = 0.035, far = 0.12;
    for (const double side : {-1, 1}) {
        canvas.body({{-x - far, side * (y + far)},
                     {x + far, side * (y + far)},
                     {x + near, side * (y + near)},
                     {-x - near, side * (y + near)}},
                    Colour::wood);
        for (const double up : {-1, 1})
            canvas.body({{side * (x + far), up * (y + far)},
                         {side * (x + near), up * (y + near)},
                         {side * (x + near), up * half_goal},
                         {side * (x + far), up * half_goal}},
                        Colour::wood);
    }
}

/// Each is drawn outside of the line that the disc bounces off.
inline void draw_cushions(Canvas &canvas) {
    constexpr double half = 0.016; // of its width
    for (const Segment &each : cushions()) {
        const bool along = each.start.y() == each.end.y();
        const auto moved = [&](const Vec2 &at) {
            const double out = at.x() > 0 ? half : -half, up = at.y() > 0 ? half : -half;
            return Vec2{at + (along ? Vec2{0, up} : Vec2{out, up})};
        };
        canvas.bar({moved(each.start), moved(each.end)}, Colour::green, 8);
    }
}

/// @param light  how bright the lamp of a goal is that has just been scored, up to 1
inline void draw_goal(Canvas &canvas, int side, double light) {
    const double x = side * half_length, deep = side * (half_length + 0.12), y = half_goal;
    canvas.area(box({x, -y}, {deep, y}), Colour::line).strength = 0.35;
    canvas.beam({{deep, 0.02 - y}, {deep, y - 0.02}}, side < 0 ? Colour::blue : Colour::orange, 3 + 7 * light)
        .strength = 0.6 + 0.4 * light;
}

inline void draw_table(Canvas &canvas, bool well) {
    canvas.line({{0, -half_width}, {0, half_width}}, Colour::ink).strength = 0.3;
    canvas.line(arc({0, 0}, 0.17), Colour::ink).strength = 0.3;
    canvas.dot({0, 0}, 0.012, Colour::ink).strength = 0.4;
    draw_frame(canvas);
    draw_cushions(canvas);
    if (!well) return;
    for (const double radius : {0.06, 0.26, 0.42})
        canvas.line(arc({0, 0}, radius), Colour::violet).strength = 0.9 - 1.2 * radius;
}

inline void draw_mallet(Canvas &canvas, const Player &player, Colour colour) {
    canvas.ball(player.mallet, mallet_radius, colour);
    canvas.dot(player.mallet, 0.4 * mallet_radius, Colour::ink).strength = 0.5;
}
/// Above all that's on the table, which is seen through it.
inline void draw_arm(Canvas &canvas, const Player &player, Colour colour) {
    std::vector<Vec2> joints =
        forward_kinematics::joints({shoulder, 0}, {{arm.first, player.pose.first}, {arm.second, player.pose.second}});
    for (Vec2 &joint : joints) joint = seen_from(player.side, Vec2{joint});
    canvas.bar(joints, colour, 7).strength = 0.55;
    if (joints.size() < 2) return;
    canvas.ball(joints[0], 0.05, Colour::dim);
    canvas.ball(joints[1], 0.026, Colour::ink).strength = 0.8;
}

inline void draw_sparks(Canvas &canvas, const std::vector<Particle> &sparks) {
    for (const Particle &each : sparks)
        canvas.lamp(each.position - Vec2{half_length, half_width}, 0.015 * std::max(0.2, 1 - each.age / each.life),
                    Colour::amber);
}
} // namespace play
