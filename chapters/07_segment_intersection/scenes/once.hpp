#pragma once
// The ball bounces off the first wall that its motion meets, once a frame.
#include "shared.hpp"

namespace play {

struct Once : RoomScene {
    static constexpr std::string_view name = "bounces once a frame (7.2)";

    Once() { still_time = 2.5; }

    void move(double dt) override { ball = next_frame(ball, walls, dt); }

    void draw(Canvas &canvas) const override {
        draw_room(canvas);
        draw_prints(canvas);
        draw_ball(canvas);
        draw_marks(canvas);
    }
};
} // namespace play
