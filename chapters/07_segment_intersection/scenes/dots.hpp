#pragma once
// Where the line along an arrow crosses the lines of the walls: a lamp on a wall, and a small one beyond its ends.
#include "shared.hpp"

namespace play {

struct Dots : RoomScene {
    static constexpr std::string_view name = "asks 7.1";
    double time = 0; ///< [s]

    Dots() {
        still_time = 1.2;
        ball = {{4.6, 2.6}, {9, 14}};
    }

    void begin() override { point(); }
    void move(double) override {}
    void step(double dt) override { // the arrow swings, and is never parallel to a wall
        time += dt;
        if (!untouched) return;
        const double there = time / 2 - std::floor(time / 2), way = there < 0.5 ? 2 * there : 2 - 2 * there;
        aim(17 * (Vec2{0.6, 0.8} + way * (3 - 2 * way) * way * Vec2{-0.4, 0.15}).normalized());
    }

    void draw(Canvas &canvas) const override {
        draw_room(canvas);
        const Segment motion{ball.position, ball.position + arrow_time * ball.velocity};
        const Vec2 far = 100 * (motion.end - motion.start);
        canvas.dotted({motion.start - far, motion.end + far}, Colour::blue, 3);
        std::optional<LineIntersection> next;
        for (const Segment &wall : walls) {
            const auto found = intersect_lines(motion, wall);
            if (!found) continue;
            const auto &[t, s, point] = *found;
            if (s >= 0 && s <= 1) canvas.lamp(point, 0.2, Colour::orange);
            else {
                canvas.dotted({s < 0 ? wall.start : wall.end, point}, Colour::dim, 3);
                canvas.lamp(point, 0.1, Colour::pink);
            }
            if (s >= 0 && s <= 1 && t > 0 && (!next || t < next->t)) next = found;
        }
        draw_ball(canvas);
        if (next)
            canvas.plate((next->point + Vec2{0.9, 0.5}).cwiseMin(high - Vec2{1, 0.4}), "t = " + number(next->t, 2),
                         Colour::orange, 22);
    }
};
} // namespace play
