// A sea anemone: its arms reach for your finger, or for what swims by.
#include "sketch.hpp"
using namespace demo;
using forward_kinematics::Link;

//> The sketch: a sea anemone
struct Anemone : Scene {
    std::vector<std::vector<Link>> arms;
    Vec2 prey{8, 6};
    double time = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    static Vec2 foot(std::size_t arm) { return {5.2 + 0.7 * double(arm), 0}; }
    void begin() override {
        for (int i = 0; i < 9; ++i) {
            arms.push_back(std::vector<Link>(12, {0.45, 0.05 * (4 - i)}));
            arms.back()[0].angle += std::numbers::pi / 2;
        }
    }
    void step(double dt) override {
        time += dt;
        const Vec2 target = hand.down ? hand.at : Vec2{8 + 6 * std::sin(0.6 * time), 5 + 2 * std::sin(time)};
        prey = time_based_motion::follow(prey, target, 0.3, dt);
        for (std::size_t i = 0; i < arms.size(); ++i) arms[i] = inverse_kinematics::ccd_sweep(foot(i), arms[i], prey);
    }
    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < arms.size(); ++i) {
            const std::vector<Vec2> joints = forward_kinematics::joints(foot(i), arms[i]);
            canvas.bar(joints, Colour::violet, 10);
            canvas.lamp(joints.back(), 0.12, Colour::pink);
        }
        canvas.lamp(prey, 0.2, Colour::amber);
    }
};
SKETCH(Anemone, "A sea anemone")
