#pragma once
// Two motors, and a hand that leaves a mark.
#include "shared.hpp"

namespace play {

struct Draws : Scene {
    static constexpr std::string_view name = "an arm that draws (9.1)";
    Slider rate = slider("second motor", "rad/s", -6, 6, 1, 4);
    Arm arm{{3, 0}, {2, 0}, {}};

    Draws() { still_time = 3; }

    View view() const override { return {{-7.6, -5.2}, {7.6, 5.2}, Stage::night}; }
    void changed() override { arm.trail.clear(); }
    void step(double dt) override {
        next_frame(arm, 1, rate, dt);
        if (arm.trail.size() > 378) arm.trail.erase(arm.trail.begin()); // once around
        for (Link *link : {&arm.first, &arm.second}) link->angle = std::remainder(link->angle, 360 * degree);
    }

    void draw(Canvas &canvas) const override {
        const auto [elbow, hand_now] = two_links(arm.first, arm.second);
        std::vector<Vec2> mark;
        for (std::size_t i = 0; i < arm.trail.size(); i += 3) mark.push_back(arm.trail[i]);
        mark.push_back(hand_now);
        canvas.beam(std::move(mark), Colour::pink, 4);
        canvas.ball({0, 0}, 0.4, Colour::dim);
        steel_arm(canvas, {{0, 0}, elbow, hand_now}, Colour::dim, 18, 0.2);
        canvas.lamp(hand_now, 0.16, Colour::pink);
    }
};
} // namespace play
