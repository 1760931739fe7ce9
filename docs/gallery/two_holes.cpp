// A ship and two holes: press where it is to start, and let it go.
#include "sketch.hpp"
using namespace demo;

//> The sketch: two holes
struct TwoHoles : Scene {
    const std::vector<Vec2> holes{{-6, 0}, {6, 0}};
    motion::State ship{{0, 7}, {5.5, 0}};
    std::vector<Vec2> path;

    View view() const override { return {{-16, -9}, {16, 9}, Stage::night}; }
    void press(const Vec2 &at) override { ship = {at, {0, 0}}, path.clear(); }
    void step(double dt) override {
        for (const Vec2 &hole : holes)
            ship.velocity += dt * gravity_wells::softened_gravity(ship.position - hole, 400, 1);
        path.push_back(ship.position += dt * ship.velocity);
        if (path.size() > 200) path.erase(path.begin());
        if (ship.position.norm() > 18) press({0.5, 7}); // it's gone: the next one
    }
    void draw(Canvas &canvas) const override {
        for (const Vec2 &hole : holes) canvas.lamp(hole, 0.8, Colour::amber);
        canvas.trail(path, Colour::blue, 6);
        canvas.ball(ship.position, 0.3, Colour::orange);
    }
};
SKETCH(TwoHoles, "Between two holes")
