#pragma once
// Two circles cross where an elbow can be: both arms that reach the fly.
#include "shared.hpp"

namespace play {

struct Both : FlyScene {
    static constexpr std::string_view name = "both elbows (10.2)";
    const Arm arm{3, 2};

    Both() { still_time = 1.5; }

    /// It stays where there are two, since the border is what's asked for.
    Vec2 wandering() const override {
        return (3 + 1.3 * std::sin(1.1 * time)) * at_angle(0.9 + 1.3 * std::sin(0.9 * time));
    }
    void react(double) override {}

    void draw(Canvas &canvas) const override {
        const Vec2 at = fly;
        const std::vector<Pose> all = poses(arm, at);
        canvas.dotted(arc({0, 0}, arm.first), Colour::dim, 3);
        canvas.dotted(arc(at, arm.second), Colour::dim, 3);
        draw_base(canvas, {0, 0});
        for (std::size_t i = all.size(); i-- > 0;)
            steel_arm(canvas, joints_of(arm, all[i]), i == 0 ? Colour::blue : Colour::orange, 18);
        if (all.empty()) canvas.ball({0, 0}, 0.17, Colour::ink);
        draw_fly(canvas);
        if (all.empty()) say(canvas, "no arm", Colour::pink);
        else say(canvas, number(double(all.size()), 0, all.size() == 1 ? "arm" : "arms"), Colour::ink);
    }
};
} // namespace play
