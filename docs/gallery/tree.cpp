// A tree in the wind: hold your finger to one side, and it bends that way.
#include "sketch.hpp"
using namespace demo;
using forward_kinematics::Frame;

//> The sketch: a tree in the wind
struct Tree : Scene {
    double time = 0, wind = 0; // [s], [rad]

    View view() const override { return {{0, 0}, {16, 9}, Stage::hills}; }
    void step(double dt) override {
        time += dt;
        wind = 0.03 * std::sin(time) + (hand.down ? 0.02 * (8 - hand.at.x()) : 0);
    }
    static Frame bent(double along, double angle) { // seen from the frame at its foot
        return {{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}, {along, 0}};
    }
    void grow(Canvas &canvas, const Frame &foot, double length, int level) const {
        const Frame tip = forward_kinematics::compose(foot, bent(length, 0));
        canvas.line({foot.origin, tip.origin}, level > 2 ? Colour::wood : Colour::green, 1 + 1.5 * level);
        if (level == 0) return;
        for (const double angle : {-0.5, 0.4})
            grow(canvas, forward_kinematics::compose(foot, bent(length, angle + wind)), 0.76 * length, level - 1);
    }
    void draw(Canvas &canvas) const override { grow(canvas, {{0, 1}, {-1, 0}, {8, 0.4}}, 2.1, 7); }
};
SKETCH(Tree, "A tree in the wind")
