#pragma once
// A smooth wall that the reader turns: angle in, angle out. What was there before the turn stays, to compare.
#include "shared.hpp"

namespace play {

struct OffWall : TurningScene {
    static constexpr std::string_view name = "a wall (6.2)";

    Vec2 after(const Vec2 &normal) const override { return reflect(before, normal); }
    void move(double dt) override { next_frame(ball, {0, 0}, normal(), dt); }

    void draw(Canvas &canvas) const override {
        const Vec2 end = at_angle(angle_deg * degree);
        draw_wall(canvas, -reach * end, reach * end);
        draw_angles(canvas, 0);
        if (turned_by() != 0) draw_turn(canvas);
        draw_ball(canvas);
    }
    /// How far the wall has been turned, and the ball's path.
    void draw_turn(Canvas &canvas) const {
        const Vec2 was = at_angle(from_deg * degree), end = at_angle(angle_deg * degree);
        const Vec2 old = after(turned(was)), now = after(normal());
        for (const auto &[at, one, other, radius] :
             {std::tuple{Vec2{0, 0}, was, end, reach - 0.3}, {meets(), old, now, 3.2}}) {
            const double first = direction_of(one), by = turn(one, other);
            canvas.dotted({at, at + (radius + 0.5) * one}, Colour::violet, 3);
            canvas.line(arc(at, radius, first, first + by), Colour::violet, 5);
            canvas.plate(at + (radius + 0.9) * at_angle(first + by / 2), number(std::abs(by) / degree, 0) + "°",
                         Colour::violet, 24);
        }
    }
};
} // namespace play
