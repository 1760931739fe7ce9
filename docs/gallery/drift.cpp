// A ship that drifts: press, and its engine burns towards your finger.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a ship that drifts
struct Drift : Scene {
    motion::State ship{{5, 3}, {2, 1}};
    std::vector<Vec2> way;
    double time = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    Vec2 engine() const { // [m/s²]
        if (untouched) return {2 * std::cos(time), std::sin(1.7 * time)};
        return hand.down ? Vec2{5 * (hand.at - ship.position).normalized()} : Vec2{0, 0};
    }
    static Vec2 wrapped(const Vec2 &at) {
        return {at.x() - 16 * std::floor(at.x() / 16), at.y() - 9 * std::floor(at.y() / 9)};
    }
    void step(double dt) override {
        time += dt;
        ship = motion::accelerated_motion(ship, engine(), dt);
        way.push_back(ship.position = wrapped(ship.position));
        if (way.size() > 40) way.erase(way.begin());
    }
    void draw(Canvas &canvas) const override {
        for (int i = 1; i < 8; ++i)
            canvas.ball(wrapped(motion::uniform_motion({2.3 * i, 4.1 * i}, {0.4 * i - 2, 0.3}, time)), 0.2 + 0.06 * i,
                        Colour::dim);
        canvas.trail(way, Colour::amber, 8);
        canvas.ball(ship.position, 0.25, Colour::orange);
    }
};
SKETCH(Drift, "A ship that drifts")
