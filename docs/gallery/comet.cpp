// A comet: it flies after your finger, and each part of its tail flies after the one before.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a comet
struct Comet : Scene {
    std::vector<Vec2> parts = std::vector<Vec2>(24, Vec2{8, 4.5});
    double time = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        const Vec2 alone{8 + 6 * std::sin(1.1 * time), 4.5 + 3.5 * std::sin(1.7 * time)};
        Vec2 target = hand.down ? hand.at : alone;
        for (Vec2 &part : parts) {
            part = time_based_motion::follow(part, target, 0.03, dt);
            target = part; // of the next one
        }
    }
    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < parts.size(); ++i)
            canvas.lamp(parts[i], 0.35 / (1 + 0.15 * double(i)), i == 0 ? Colour::amber : Colour::violet);
    }
};
SKETCH(Comet, "A comet")
