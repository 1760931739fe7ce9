// A tower of balls: it falls, and what the large balls have, the small one gets.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a tower of balls
struct Tower : Scene {
    struct Storey {
        double y, radius; // [m]
        momentum::Body body;
    };
    std::vector<Storey> tower;

    Tower() { still_time = 1.5; }
    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void begin() override { tower = {{0, 0, {0, 0}}, {1.2, 0.8, {1, 0}}, {2.5, 0.4, {8, 0}}, {3.2, 0.2, {64, 0}}}; }
    void step(double dt) override {
        for (auto &it : tower) {
            if (it.body.inverse_mass > 0) it.body.velocity -= 4 * dt;
            it.y += it.body.velocity * dt;
        }
        for (std::size_t i = 0; i + 1 < tower.size(); ++i) meet(tower[i], tower[i + 1]);
    }
    static void meet(Storey &lower, Storey &upper) {
        if (upper.y - lower.y > lower.radius + upper.radius) return;
        const double j = momentum::impulse(lower.body, upper.body, 0.9);
        lower.body.velocity -= j * lower.body.inverse_mass;
        upper.body.velocity += j * upper.body.inverse_mass;
        upper.y = lower.y + lower.radius + upper.radius; // not into each other
    }
    void draw(Canvas &canvas) const override {
        canvas.area(box({0, 0}, {16, 0.1}), Colour::line);
        for (const auto &it : tower) canvas.ball({8, it.y + 0.1}, it.radius, Colour::orange);
    }
};
SKETCH(Tower, "A tower of balls")
