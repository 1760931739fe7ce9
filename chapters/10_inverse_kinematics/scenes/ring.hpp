#pragma once
// An arm reaches for the fly as far as it goes, in a ring.
#include "shared.hpp"

namespace play {

struct Ring : FlyScene {
    static constexpr std::string_view name = "out of reach (10.3)";
    Slider upper_arm = slider("upper arm", "m", 0.5, 3, 0.1, 3);
    Pose pose{0.6, 0.9};

    Ring() { still_time = 1; }

    Arm arm() const { return {upper_arm, 2}; }
    Vec2 wandering() const override {
        const double far = 3.5 + 3 * std::sin(1.1 * time);
        return {far * std::cos(1.6 * time), 1.2 + 0.6 * far * std::sin(1.6 * time)};
    }
    void react(double) override { pose = reach_for(arm(), pose, fly); }

    void draw(Canvas &canvas) const override {
        const double most = upper_arm + 2, least = std::abs(upper_arm - 2);
        std::vector<Vec2> ring = arc({0, 0}, most), hole = arc({0, 0}, least);
        canvas.dotted(ring, Colour::green, 3);
        if (least > 0) canvas.dotted(hole, Colour::green, 3);
        ring.insert(ring.end(), hole.rbegin(), hole.rend());
        canvas.area(std::move(ring), Colour::green).strength = 0.22;
        const std::vector<Vec2> all = joints_of(arm(), pose);
        const Vec2 at = fly, gap = at - all.back();
        canvas.dotted({all.back(), at}, Colour::pink, 4);
        draw_base(canvas, {0, 0});
        steel_arm(canvas, all, Colour::blue, 18);
        draw_fly(canvas);
        if (gap.norm() > 0.005) say(canvas, number(gap.norm(), 2, "m"), Colour::pink);
    }
};
} // namespace play
