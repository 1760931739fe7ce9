#pragma once
// A ball with a size: it turns where its edge first touches a wall, or a corner.
#include "shared.hpp"

namespace play {

struct Disc : RoomScene {
    static constexpr std::string_view name = "has a size (7.5)";
    Slider radius = slider("radius", "m", 0.1, 0.5, 0.01, 0.15);
    Vec2 contact{0, 0};
    double since = 9; ///< the last contact [s]

    Disc() { still_time = 2.5; }

    double size() const override { return radius; }
    void move(double dt) override {
        const Vec2 was = ball.velocity;
        ball = next_frame(ball, size(), walls, dt);
        since += dt;
        if ((ball.velocity - was).norm() < 1e-9) return;
        contact = ball.position - size() * (ball.velocity - was).normalized();
        since = 0;
    }
    bool is_lit_by(const Segment &motion, const Segment &wall) const override {
        return time_of_impact(motion, size(), wall).has_value();
    }

    void draw(Canvas &canvas) const override {
        draw_room(canvas);
        draw_prints(canvas);
        draw_ball(canvas);
        if (since < 0.5) canvas.sparks({{contact, 0.4, 1 - 2 * since}, {contact, 0.15, 1 - since}}, Colour::pink);
        draw_marks(canvas);
    }
};
} // namespace play
