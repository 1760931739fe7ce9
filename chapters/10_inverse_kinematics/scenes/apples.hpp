#pragma once
// An autumn: the arm catches apples, and its reader leads the hand.
#include "shared.hpp"

namespace play {

struct Apples : FlyScene {
    static constexpr std::string_view name = "apples (10.4)";
    Orchard orchard{{0.6, 0.9}, {}, 0, 0};
    unsigned number_of_apples = 0;
    double until_next = 0; ///< apple [s]
    double over = 0;       ///< how long the game has been, once it is [s]

    Apples() : FlyScene{{-6.8, -3.6}, {6.8, 4.05}} { still_time = 3; }

    View view() const override { return {low, high, Stage::hills, grass}; }
    void take_over() override {
        orchard = {orchard.pose, {}, 0, 0};
        until_next = over = 0;
    }
    bool ended() const { return orchard.caught >= 10 || orchard.missed >= 10; }
    /// Nobody plays: it waits below the first apple.
    Vec2 wandering() const override {
        return orchard.apples.empty() ? fly.at() : Vec2{orchard.apples.front().place.x(), -1};
    }
    void react(double dt) override {
        if (!ended()) return next_frame(orchard, number_of_apples, until_next, fly, dt);
        if ((over += dt) > 3) take_over();
    }

    /// So many apples in a basket that's here.
    static void draw_basket(Canvas &canvas, double x, int count, Colour apples, Colour colour, const char *word) {
        std::vector<Vec2> pile;
        for (int i = 0; i < std::min(count, 10); ++i)
            pile.push_back({x - 0.9 + 0.45 * (i % 5), grass + 0.45 + 0.4 * (i / 5)});
        canvas.balls(std::move(pile), 0.24, apples);
        canvas.body({{x - 1.2, grass + 0.45}, {x + 1.2, grass + 0.45}, {x + 1, grass - 0.3}, {x - 1, grass - 0.3}},
                    Colour::wood);
        canvas.plate({x, grass + 1.45}, number(count, 0, word), colour, 22);
    }
    void draw(Canvas &canvas) const override {
        std::vector<Vec2> leaves, apples;
        for (int i = 0; i <= 12; ++i) leaves.push_back({-7 + 1.17 * i, 4 + 0.25 * ((5 * i) % 3)});
        for (const Apple &apple : orchard.apples) apples.push_back(apple.place);
        canvas.bar({{0, grass}, {0, 0}}, Colour::wood, 22);
        draw_basket(canvas, -5, orchard.caught, Colour::pink, Colour::green, "caught");
        draw_basket(canvas, 5, orchard.missed, Colour::wood, Colour::pink, "missed");
        const std::vector<Vec2> all = joints_of(picker, orchard.pose);
        steel_arm(canvas, all, Colour::blue, 18);
        canvas.ball(all.back(), catch_radius, Colour::amber);
        canvas.balls(std::move(apples), 0.24, Colour::pink);
        canvas.balls(std::move(leaves), 0.8, Colour::green);
        draw_fly(canvas);
        if (ended())
            canvas.plate({0, 2}, orchard.missed < 10 ? "ten caught" : "ten missed",
                         orchard.missed < 10 ? Colour::green : Colour::pink, 34);
    }
};
} // namespace play
