#pragma once
// Two ropes pull two carts, both in the same way. Which cart is faster, and can they be kept from moving?
#include "shared.hpp"

namespace play {

struct Ropes : Scene {
    static constexpr std::string_view name = "ropes (2.1)";
    static constexpr double newton = 0.075,
                            rails[]{0, 2.5}; // so long is an arrow of 1 N [m]; how high the rails are [m]
    Slider mass_of_a = slider("mass of A", "kg", 0.5, 10, 0.5, 2);
    Slider mass_of_b = slider("mass of B", "kg", 0.5, 10, 0.5, 3);
    Handle tips[2]{handle({0, 0}, {-30, -30}, {40, 30}), handle({0, 0}, {-30, -30}, {40, 30})};
    Vec2 ropes[2]{{12, 6}, {-5, 10}};           ///< what pulls at each cart [N]
    RailCart carts[2];                          ///< A and B
    double time = 0, there[2]{-1, -1}, out = 0; ///< when each was at the post, and since both are [s]
    bool aiming = false;

    Ropes() { still_time = 1.3; }

    View view() const override { return {{0, -1}, {10, 4.625}, Stage::hills, -0.2}; }
    /// The ropes, and what rail and weight together answer to them.
    std::vector<Vec2> forces() const { return {ropes[0], ropes[1], {0, -(ropes[0].y() + ropes[1].y())}}; }
    double side() const { return ropes[0].x() + ropes[1].x() < 0 ? -1 : 1; }
    double post() const { return 5 + 3.4 * side(); }
    Vec2 middle(int i) const { return {carts[i].x, rails[i] + 0.33}; }
    void begin() override {
        const double masses[]{mass_of_a, mass_of_b};
        for (int i : {0, 1}) {
            carts[i] = {5 - 3.2 * side(), {masses[i], 0}};
            there[i] = -1;
        }
        time = out = 0;
        move_tips();
    }
    void changed() override { begin(); }
    void move_tips() {
        for (int i : {0, 1}) tips[i].move(middle(0) + newton * ropes[i]);
    }
    void drag() override {
        for (int i : {0, 1}) {
            const Vec2 rope = (tips[i].at() - middle(0)) / newton;
            const Vec2 shorter = rope / std::max(1.0, rope.norm() / 30);
            ropes[i] = {std::round(shorter.x()), std::round(shorter.y())};
        }
        move_tips();
        aiming = true;
    }
    void step(double dt) override {
        if (aiming && hand.down) return; // while the reader aims, time stands still
        if (aiming) begin();
        aiming = false;
        time += dt;
        for (int i : {0, 1}) {
            next_frame(carts[i], forces(), dt);
            if (there[i] < 0 && side() * (carts[i].x - post()) >= 0) there[i] = time;
        }
        move_tips();
        if ((there[0] >= 0 && there[1] >= 0) || std::max(std::abs(carts[0].x), std::abs(carts[1].x)) > 200) out += dt;
        if (out > 1.5) begin();
    }

    void draw(Canvas &canvas) const override {
        constexpr Colour colours[]{Colour::blue, Colour::green};
        const char *names[]{"A", "B"};
        const std::vector<Vec2> all = forces();
        const Vec2 net = all[0] + all[1] + all[2];
        for (const double x : {0.7, 9.3}) canvas.bar({{x, -0.1}, {x, rails[1] - 0.1}}, Colour::wood, 9);
        for (int i : {0, 1}) {
            const Vec2 at = middle(i);
            draw_rail(canvas, rails[i], 0, 10);
            canvas.bar({{post(), rails[i]}, {post(), rails[i] + 1.2}}, Colour::wood, 5);
            draw_cart(canvas, carts[i], rails[i], colours[i], names[i]);
            canvas.arrow(at, at + newton * all[2], Colour::dim, 4);
            for (const Vec2 &rope : ropes) canvas.arrow(at, at + newton * rope, Colour::orange, 4);
            const Vec2 above{at.x(), rails[i] + load_height(carts[i].cart.mass) + 0.2};
            canvas.arrow(above, above + newton * net, Colour::ink, 6);
            const Vec2 acceleration = acceleration_due_to(all, carts[i].cart.mass);
            canvas.plate(above + Vec2{0, 0.36}, number(acceleration.x(), 1, "m/s²"), colours[i], 22);
            if (there[i] >= 0) canvas.plate({post(), rails[i] + 1.5}, number(there[i], 2, "s"), colours[i], 22);
        }
        canvas.plate({5, 4.3}, "net force " + number(net.x(), 1, "N"), Colour::ink, 22);
    }
};
} // namespace play
