#pragma once
// An arm that's led around by its hand, and a pale one whose motors know nothing of whole turns.
#include "shared.hpp"

namespace play {

struct Around : FlyScene {
    static constexpr std::string_view name = "led around (10.5)";
    const Arm arm{3, 2};
    Pose pose{0.1, 1.57}, pale = pose;
    std::vector<Vec2> swept; ///< where the pale hand has just been

    Around() : FlyScene{{-7.2, -4.05}, {7.2, 4.05}} { still_time = 1.2; }

    /// To and fro, on the side where nothing happens.
    Vec2 wandering() const override { return 3.6 * at_angle(0.6 + 1.9 * std::sin(1.2 * time)); }
    void react(double dt) override {
        next_frame(pose, continued(arm, pose, fly), dt);
        next_frame(pale, reach_for(arm, pale, fly), dt);
        for (double *angle : {&pose.first, &pose.second, &pale.first, &pale.second})
            if (std::abs(*angle) > 1e4) *angle = std::remainder(*angle, 360 * degree); // it was led around for hours
        swept.push_back(joints_of(arm, pale).back());
        if (swept.size() > 30) swept.erase(swept.begin());
    }

    void draw(Canvas &canvas) const override {
        canvas.dotted(arc({0, 0}, 3.6), Colour::dim, 2);
        const std::vector<Vec2> all = joints_of(arm, pose), behind = joints_of(arm, pale);
        if (swept.size() > 1) canvas.trail(swept, Colour::pink, 6);
        draw_pale(canvas, behind, 0.8);
        draw_base(canvas, {0, 0});
        steel_arm(canvas, all, Colour::blue, 18);
        draw_fly(canvas);
        draw_turns(canvas);
        canvas.plate({-5.2, 3.2}, "yours " + degrees(pose.first), Colour::blue, 24);
        canvas.plate({-5.2, 2.3}, "pale " + degrees(pale.first), Colour::dim, 24);
    }
    /// The first angle with all of its turns, the last five of them.
    void draw_turns(Canvas &canvas) const {
        const double last = std::clamp(pose.first, -1e5, 1e5), most = 10 * std::numbers::pi;
        std::vector<Vec2> turns;
        for (double angle = std::abs(last) > most ? std::copysign(std::abs(last) - most, last) : 0;
             std::abs(angle) < std::abs(last); angle += std::copysign(0.2, last))
            turns.push_back((0.6 + 0.05 * std::min(std::abs(angle), 32.0)) * at_angle(angle));
        turns.push_back((0.6 + 0.05 * std::min(std::abs(last), 32.0)) * at_angle(last));
        canvas.line(std::move(turns), Colour::amber, 4);
    }
};
} // namespace play
