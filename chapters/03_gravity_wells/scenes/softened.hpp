#pragma once
// Straight through a softened hole. How fast is the ship 4 m before the middle, and 4 m behind it?
#include "shared.hpp"

namespace play {

struct Softened : Space {
    static constexpr std::string_view name = "softened (3.6)";
    static constexpr double gate = 4; // [m]
    Slider epsilon = slider("softened by", "m", 0.5, 5, 0.5, 2);
    Slider push = slider("push", "m/s", 0, 8, 0.5, 0);
    struct Passing {
        Vec2 at{0, 0};
        double speed = 0; ///< [m/s]
    };
    Passing in, out;
    std::vector<Vec2> far_ends;

    Softened() { still_time = 2.2; }

    double widest() const override { return 39; }
    bool can_swallow() const override { return false; }
    State begins() const override { return {start, {0, push}}; }
    void begin() override {
        Space::begin();
        in = out = {};
        far_ends.clear();
    }
    void changed() override { begin(); }
    void fly(double dt) override {
        auto &[at, velocity] = ship.state;
        const double before = at.norm(), slow = velocity.norm();
        const bool outwards = at.dot(velocity) > 0;
        velocity += dt * softened_gravity(at, mu, epsilon);
        at += dt * velocity;
        const double after = at.norm();
        if ((before > gate) != (after > gate)) {
            const double part = (gate - before) / (after - before) + 0.5; // a velocity is that of its step's middle
            const double speed = slow + part * (velocity.norm() - slow);
            if (before > gate) in = {at, speed}, out = {};
            else out = {at, speed};
        }
        if (outwards && at.dot(velocity) <= 0) far_ends.push_back(at);
        if (far_ends.size() > 12) far_ends.erase(far_ends.begin());
    }

    void draw(Canvas &canvas) const override {
        for (const double part : {1.0, 0.66, 0.33}) // the blur
            canvas.area(arc({0, 0}, part * epsilon), Colour::violet).strength = 0.2;
        canvas.dotted(arc({0, 0}, gate), Colour::dim, 2);
        draw_path(canvas);
        for (const Vec2 &each : far_ends) canvas.lamp(each, 0.3, Colour::amber);
        draw_passing(canvas, in, "in: ", Colour::green);
        draw_passing(canvas, out, "out: ", out.speed > in.speed + 0.5 ? Colour::pink : Colour::green);
        draw_ship(canvas);
    }
    static void draw_passing(Canvas &canvas, const Passing &here, const char *words, Colour colour) {
        if (here.speed <= 0) return;
        canvas.dot(here.at, 0.25, colour);
        canvas.plate(1.9 * here.at + Vec2{0, here.at.y() < 0 ? -1.4 : 1.4}, words + number(here.speed, 1, "m/s"),
                     colour, 20);
    }
};
} // namespace play
