// Curling: hold your finger in front of the stone to sweep the ice, and the stone goes farther.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;

//> The sketch: curling
struct Curling : Scene {
    std::vector<motion::State> stones;
    unsigned thrown = 0;
    double wait = 0; // since it stopped [s]

    Curling() { still_time = 30; }
    View view() const override { return {{0, 0}, {16, 9}, Stage::paper}; }
    void begin() override { slide(); }
    void slide() {
        if (stones.size() == 6) stones.clear();
        ++thrown;
        stones.push_back({{0.5, 4.5}, {4 + 0.4 * course::chance(2, thrown), 0.6 * course::chance(1, thrown) - 0.3}});
    }
    void step(double dt) override {
        auto &stone = stones.back();
        const bool swept = hand.down && (hand.at - stone.position).norm() < 2;
        stone.velocity = inclined_planes::table_friction(stone.velocity, swept ? 0.4 : 0.8, dt);
        stone.position += stone.velocity * dt;
        wait = stone.velocity.norm() == 0 || stone.position.x() > 16 ? wait + dt : 0;
        if (wait > 1) slide();
    }
    void draw(Canvas &canvas) const override {
        for (const double radius : {2.4, 1.6, 0.8})
            canvas.line(arc({12.5, 4.5}, radius, 0, 2 * std::numbers::pi), Colour::blue, 8);
        for (const auto &stone : stones) canvas.ball(stone.position, 0.35, Colour::pink);
    }
};
SKETCH(Curling, "Curling")
