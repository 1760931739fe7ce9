// Table hockey without its arms: hold the left mallet by pressing; each machine is one line.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a duel
struct Duel : Scene {
    table_hockey::World now = table_hockey::opening();

    View view() const override { return {{-1.2, -0.675}, {1.2, 0.675}, Stage::felt}; }
    void step(double dt) override {
        const Vec2 at = now.disc.place;
        const bool slow = now.disc.velocity.norm() < 1;
        const Vec2 left = slow && at.x() < 0 ? at : Vec2{-0.8, 0.7 * at.y()};
        const Vec2 right = slow && at.x() > 0 ? at : Vec2{0.8, 0.7 * at.y()};
        now = table_hockey::step(now, {hand.down ? hand.at : left, right}, dt);
    }
    void draw(Canvas &canvas) const override {
        for (const auto &wall : table_hockey::cushions()) canvas.bar({wall.start, wall.end}, Colour::wood, 8);
        canvas.ball(now.left.mallet, table_hockey::mallet_radius, Colour::blue);
        canvas.ball(now.right.mallet, table_hockey::mallet_radius, Colour::pink);
        canvas.ball(now.disc.place, table_hockey::disc_radius, Colour::amber);
        canvas.plate({0, 0.6}, number(now.left.goals, 0) + " : " + number(now.right.goals, 0));
    }
};
SKETCH(Duel, "A duel")
