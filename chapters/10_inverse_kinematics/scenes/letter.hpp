#pragma once
// An arm that writes letters.
#include "shared.hpp"

namespace play {

struct Letter : Scene {
    static constexpr std::string_view name = "your letter (10.8)";
    /// Each without lifting the pen, in a box that is 2 wide and 3 high.
    const std::vector<std::vector<Vec2>> letters{{{0, 0}, {0, 3}, {2, 3}, {0, 3}, {0, 1.6}, {1.5, 1.6}},
                                                 {{0, 0}, {1, 3}, {2, 0}, {1.6, 1.2}, {0.4, 1.2}},
                                                 {{0, 0}, {0, 3}, {1, 1.2}, {2, 3}, {2, 0}},
                                                 {{2, 3}, {0, 3}, {0, 1.6}, {1.5, 1.6}, {0, 1.6}, {0, 0}, {2, 0}},
                                                 {{0, 3}, {0.5, 0}, {1, 1.8}, {1.5, 0}, {2, 3}}};
    Button next = button("n", "Next letter", [this] { next_letter(); });
    const Arm arm{3, 2};
    std::size_t letter = 0;
    std::vector<Pose> poses;
    double time = 0; ///< since the letter began [s]

    Letter() { still_time = 2.2; }

    View view() const override { return {{-1.5, -3.15}, {7.1, 2.55}, Stage::night}; }
    void begin() override {
        std::vector<Vec2> path = letters[letter];
        for (Vec2 &corner : path) corner = Vec2{1.3, -1.8} + 1.35 * corner;
        const std::vector<Pose> start = inverse_kinematics::poses(arm, path.front());
        poses = start.empty() ? start : write(arm, start.front(), path);
        time = 0;
    }
    void next_letter() {
        letter = (letter + 1) % letters.size();
        begin();
    }
    void press(const Vec2 &) override { next_letter(); }
    bool done() const { return time * 30 > double(poses.size()); }
    void step(double dt) override {
        time += dt;
        if (time * 30 > double(poses.size()) + 45) next_letter();
    }

    void draw(Canvas &canvas) const override {
        canvas.body(box({0.8, -2.2}, {4.5, 2.7}), Colour::line).strength = 0.25; // a slate
        const std::size_t count = std::min(std::size_t(time * 30) + 1, poses.size());
        std::vector<Vec2> ink;
        for (std::size_t i = 0; i < count; ++i) ink.push_back(joints_of(arm, poses[i]).back());
        canvas.beam(std::move(ink), Colour::amber, 7);
        draw_base(canvas, {0, 0});
        if (!poses.empty()) steel_arm(canvas, joints_of(arm, pen_at(poses, time)), Colour::blue, 18);
        if (done()) canvas.plate({5.8, -2.4}, number(double(poses.size()), 0, "poses"), Colour::amber, 22);
    }
};
} // namespace play
