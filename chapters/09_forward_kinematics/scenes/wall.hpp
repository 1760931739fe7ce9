#pragma once
// A crane that plans its own trips over a wall.
#include "shared.hpp"

namespace play {

struct Wall : Scene {
    static constexpr std::string_view name = "over the wall (9.8)";
    static constexpr Crane crane{3.4, 2.6, 2.2, 2.7};
    Button other = button("n", "New", [this] { next_round(); });
    int round = 0;
    std::vector<Pose> poses;
    double time = 0; ///< of this trip [s]

    Wall() { still_time = 3; }

    View view() const override { return {{-7.8, -0.6}, {7.8, 8.75}, Stage::hills, 0}; }
    static std::vector<Vec2> joints_of(const Pose &pose) {
        return joints({0, crane.height}, {{crane.first, pose.first}, {crane.second, pose.second}});
    }
    /// A pose with all of the arm on one side of the wall. The first round's way is a long one.
    static Pose pose_on(double side, int number) {
        course::Dice dice{unsigned(number == 0 ? 10 : number) * 2654435761u + (side > 0 ? 77u : 1u)};
        for (int i = 0; i < 10000; ++i, dice.roll()) {
            const auto part = [](unsigned bits) { return double(bits % 4096) / 4096 * 2 - 1; }; // -1 to 1
            const Pose pose{part(dice.seed >> 20) * 3.1, part(dice.seed >> 8) * 2.6};
            const std::vector<Vec2> all = joints_of(pose);
            const auto is_fine = [&](const Vec2 &at) { return side * at.x() > 0.5 && at.y() > 0.3; };
            if (is_fine(all[1]) && is_fine(all[2])) return pose;
        }
        return {side > 0 ? 0 : std::numbers::pi, 0};
    }
    void begin() override {
        poses = over_the_wall(crane, pose_on(-1, round), pose_on(1, round));
        time = 0;
    }
    void next_round() {
        ++round;
        begin();
    }
    void press(const Vec2 &) override { next_round(); }
    void step(double dt) override {
        time += dt;
        if (time * 30 > double(poses.size()) + 30) time = 0;
    }

    void draw(Canvas &canvas) const override {
        canvas.bar({{0, 0}, {0, crane.height}}, Colour::ink, 9);
        for (int i = 0; i < 6; ++i) // bricks
            canvas.body(box({-0.24, 0.45 * i}, {0.24, 0.45 * (i + 1)}), Colour::orange);
        if (poses.empty()) return;
        for (const Pose &pose : {poses.front(), poses.back()}) {
            const std::vector<Vec2> all = joints_of(pose);
            canvas.line(all, Colour::dim, 8).strength = 0.4;
            canvas.dotted(arc(all.back(), 0.45), Colour::ink, 3);
        }
        const std::size_t at = std::min(std::size_t(time * 30), poses.size() - 1);
        std::vector<Vec2> way;
        for (std::size_t i = at < 40 ? 0 : at - 40; i <= at; ++i) way.push_back(joints_of(poses[i]).back());
        canvas.trail(std::move(way), Colour::pink, 8);
        const std::vector<Vec2> all = joints_of(poses[at]);
        steel_arm(canvas, all, Colour::amber, 18);
        canvas.ball(all.back(), 0.42, Colour::pink);
        if (at + 1 == poses.size())
            canvas.plate({-5.6, 7.5}, number(double(poses.size()), 0, "poses"), Colour::pink, 24);
    }
};
} // namespace play
