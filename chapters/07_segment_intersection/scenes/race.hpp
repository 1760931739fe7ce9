#pragma once
// Two balls start together: one flies on after a bounce for the time that's left of its frame, the other one waits.
#include "shared.hpp"

namespace play {

struct Race : RoomScene {
    static constexpr std::string_view name = "bounces (7.4)";
    Slider rate = slider("frames per second", "", 5, 120, 1, 30);
    Ball other = first;
    double way = 0, other_way = 0; ///< how far both have got [m]

    Race() { still_time = 3.4; }

    double step_time() const override { return 1 / rate; }
    void start() {
        ball.position = first.position;
        other = ball;
        way = other_way = 0;
        prints.clear();
        point();
    }
    void changed() override { start(); }
    void drag() override {
        RoomScene::drag();
        const Vec2 velocity = ball.velocity;
        start();
        aim(velocity);
        other = ball;
    }
    void press(const Vec2 &at) override {
        RoomScene::press(at);
        start();
    }
    void gone() override {
        RoomScene::gone();
        start();
    }
    void move(double dt) override {
        ball = move_and_bounce(ball, room, dt);
        const Vec2 before = other.position;
        other = next_frame(other, walls, dt);
        way += dt * ball.velocity.norm();
        other_way += (other.position - before).norm();
    }

    void draw(Canvas &canvas) const override {
        draw_room(canvas);
        draw_prints(canvas);
        canvas.ball(other.position, size(), Colour::dim);
        draw_ball(canvas);
        draw_marks(canvas);
        const double late = (way - other_way) / std::max(ball.velocity.norm(), 1e-9);
        if (!untouched && late > 0.005)
            canvas.plate((other.position + Vec2{0, 0.65}).cwiseMin(high - Vec2{1, 0.4}), number(late, 2, "s late"),
                         Colour::ink, 22);
    }
};
} // namespace play
