#pragma once
// Which angles bring the hand to the apple? A pose that does stays as a pale arm.
#include "shared.hpp"

namespace play {

struct Opening : Scene {
    static constexpr std::string_view name = "you find it";
    static constexpr Pose film[]{{150 * degree, -70 * degree},
                                 {60 * degree, -130 * degree},
                                 {-15 * degree, 60 * degree},
                                 {110 * degree, -120 * degree}}; // they never lead the hand to the apple
    Arm arm{3, 2};
    Vec2 apple{3, 2}; // [m]
    Pose pose = film[0];
    Handle elbow = handle({0, 0}, {-5.9, -2.4}, {6.1, 4.35}), palm = handle({0, 0}, {-5.9, -2.4}, {6.1, 4.35});
    Button other = button("n", "New", [this] { next_round(); });
    std::vector<Pose> found; ///< at most one for each side of the elbow
    double off = -1;         ///< how far beside the apple the hand was let go, negative before that [m]
    unsigned round = 0;
    double time = 0; ///< [s]

    Opening() { still_time = 1.6; }

    View view() const override { return {{-5.9, -2.4}, {6.1, 4.35}, Stage::yard, -1.9}; }
    std::vector<Vec2> now() const { return joints_of(arm, pose); }
    void place_handles() {
        elbow.move(now()[1]);
        palm.move(now()[2]);
    }
    void begin() override { place_handles(); }

    /// Another number from 0 to 1 for each seed.
    static double chance(unsigned seed) {
        seed = (seed + 11) * 2654435761u;
        return double((seed ^ seed >> 13) * 1103515245u >> 20) / 4096;
    }
    /// Another arm, and an apple that it can reach with either elbow.
    void next_round() {
        const unsigned seed = 3 * ++round;
        arm = {1.6 + 1.4 * chance(seed), 1.4 + 0.8 * chance(seed + 1)};
        const double least = std::abs(arm.first - arm.second), most = arm.first + arm.second;
        apple = (least + (0.4 + 0.4 * chance(seed + 1)) * (most - least)) * at_angle(0.1 + 0.6 * chance(seed + 2));
        pose = film[0];
        found.clear();
        off = -1;
        place_handles();
    }

    /// A link follows the pointer as well as it can: it points there.
    void drag() override {
        const std::vector<Vec2> all = now();
        const std::size_t i = (elbow.at() - all[1]).norm() > 1e-9 ? 0 : 1;
        const Vec2 is = all[i + 1] - all[i], to = (i == 0 ? elbow : palm).at() - all[i];
        double &angle = i == 0 ? pose.first : pose.second;
        angle = std::remainder(angle + std::atan2(is.x() * to.y() - is.y() * to.x(), is.dot(to)), 360 * degree);
        place_handles();
        off = -1;
        if (!hand.down) let_go(); // it's moved by a key
    }
    void let_go() override {
        off = (now()[2] - apple).norm();
        if (off > 0.15) return;
        std::erase_if(found, [&](const Pose &each) { return (each.second < 0) == (pose.second < 0); });
        found.push_back(pose);
    }
    /// It only wonders, and its hand stays beside the apple.
    void step(double dt) override {
        if (!untouched) return;
        time += dt;
        const std::size_t leg = std::size_t(time);
        const Pose &from = film[leg % std::size(film)], &to = film[(leg + 1) % std::size(film)];
        const double part = 0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, 1.3 * (time - double(leg))));
        pose = {from.first + part * (to.first - from.first), from.second + part * (to.second - from.second)};
        place_handles();
    }

    void draw(Canvas &canvas) const override {
        for (int x = -5; x <= 6; ++x) canvas.line({{double(x), -1.9}, {double(x), 4.35}}, Colour::line, 1);
        for (int y = -1; y <= 4; ++y) canvas.line({{-5.9, double(y)}, {6.1, double(y)}}, Colour::line, 1);
        canvas.bar({{0, -1.9}, {0, 0}}, Colour::wood, 18);
        for (const Pose &each : found) draw_pale(canvas, joints_of(arm, each), 0.8);
        const std::vector<Vec2> all = now();
        draw_angle(canvas, all[0], 0, pose.first, Colour::amber);
        draw_angle(canvas, all[1], pose.first, pose.second, Colour::violet);
        draw_base(canvas, {0, 0});
        steel_arm(canvas, all, Colour::blue, 18);
        const double outside = pose.first + pose.second / 2 + (pose.second < 0 ? 90 : -90) * degree;
        canvas.plate({1.25, -0.6}, degrees(pose.first, 1), Colour::amber, 22);
        canvas.plate(all[1] + 0.8 * at_angle(outside), degrees(pose.second, 1), Colour::violet, 22);
        canvas.ball(apple, 0.24, Colour::pink);
        canvas.line({apple + Vec2{0, 0.2}, apple + Vec2{0.05, 0.4}}, Colour::earth, 3);
        if (off < 0) return;
        if (off > 0.15) canvas.plate(apple + Vec2{1.4, 0.4}, number(off, 2, "m off"), Colour::pink, 22);
        else canvas.plate(apple + Vec2{1.4, 0.4}, found.size() == 2 ? "both found" : "found", Colour::green, 24);
    }
    /// How far a link bends away from straight on.
    static void draw_angle(Canvas &canvas, const Vec2 &at, double straight, double angle, Colour colour) {
        canvas.dotted({at, at + 1.3 * at_angle(straight)}, Colour::ink, 2);
        canvas.area(sector(at, 0.8, straight, straight + angle), colour).strength = 0.5;
    }
};
} // namespace play
