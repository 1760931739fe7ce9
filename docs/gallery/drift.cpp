// A ship that drifts: press, and its engine burns towards your finger.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a ship that drifts
struct Drift : Scene {
    motion::State ship{{5, 3}, {2, 1}};
    double time = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void step(double dt) override {
        const Vec2 engine = hand.down ? Vec2{hand.at - wrapped(ship.position)} : Vec2{0, 0}; // [m/s²]
        ship = motion::accelerated_motion(ship, engine, dt);
        time += dt;
    }
    static Vec2 wrapped(const Vec2 &at) {
        return {at.x() - 16 * std::floor(at.x() / 16), at.y() - 9 * std::floor(at.y() / 9)};
    }
    void draw(Canvas &canvas) const override {
        for (int i = 1; i < 8; ++i)
            canvas.ball(wrapped(motion::uniform_motion(i * Vec2{2.3, 4}, {i - 4.0, 0}, time)), 0.1 * i, Colour::dim);
        canvas.ball(wrapped(ship.position), 0.25, Colour::orange);
    }
};
SKETCH(Drift, "A ship that drifts")
