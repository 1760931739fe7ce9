#pragma once
// An arm with two links, and a fly to reach for: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace inverse_kinematics;
using forward_kinematics::joints;

inline Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// Shoulder, elbow and hand.
inline std::vector<Vec2> joints_of(const Arm &arm, const Pose &pose) {
    return joints({0, 0}, {{arm.first, pose.first}, {arm.second, pose.second}});
}
inline std::string degrees(double angle, int decimals = 0) { return number(angle / degree, decimals) + "°"; }

/// What an arm is bolted to.
inline void draw_base(Canvas &canvas, const Vec2 &at) {
    canvas.body({at + Vec2{-0.55, -0.75}, at + Vec2{0.55, -0.75}, at + Vec2{0.3, 0.1}, at + Vec2{-0.3, 0.1}},
                Colour::dim);
    canvas.ball(at, 0.34, Colour::dim);
}
/// An arm that isn't the one that counts.
inline void draw_pale(Canvas &canvas, const std::vector<Vec2> &all, double strength = 0.5) {
    canvas.line(all, Colour::dim, 7).strength = strength;
    canvas.dots(all, 0.14, Colour::dim).strength = strength;
}

/// Somewhere is a fly, and the pointer or a finger leads it. Until then it flies by itself.
struct FlyScene : Scene {
    const Vec2 low, high; ///< what's seen [m]
    Handle fly;
    double time = 0; ///< [s]

    explicit FlyScene(const Vec2 &from = {-7.2, -2.9}, const Vec2 &to = {7.2, 5.2})
        : low{from}, high{to}, fly{handle({3, 2}, from, to)} {}

    View view() const override { return {low, high, Stage::night}; }
    /// Where the fly would be by itself.
    virtual Vec2 wandering() const = 0;
    virtual void react(double dt) = 0;

    void press(const Vec2 &at) override { fly.move(at); }
    void step(double dt) override {
        time += dt;
        if (hand.inside) {
            if (untouched) take_over();
            untouched = false;
            fly.move(hand.at);
        }
        if (untouched) fly.move(wandering());
        react(dt);
    }

    void draw_fly(Canvas &canvas) const {
        const Vec2 at = fly;
        const double beat = 0.12 + 0.1 * std::sin(50 * time);
        for (const double side : {-1.0, 1.0})
            canvas.area({at, at + Vec2{0.42 * side, 0.2 + beat}, at + Vec2{0.5 * side, 0.02 + beat}}, Colour::ink)
                .strength = 0.7;
        canvas.lamp(at, 0.15, Colour::pink);
    }
    /// Beside the fly, and in the picture.
    void say(Canvas &canvas, const std::string &words, Colour colour) const {
        const double up = fly.at().y() + 1.2 > high.y() ? -0.8 : 0.7, x = fly.at().x();
        canvas.plate({std::clamp(x, low.x() + 1.2, high.x() - 1.2), fly.at().y() + up}, words, colour, 22);
    }
};
} // namespace play
