#pragma once
// How long does a fall take? A ball stops when the clock of 3.2 runs out: each throw leaves its time.
#include "shared.hpp"

namespace play {

struct Falling : Scene {
    static constexpr std::string_view name = "falling (3.2)";
    Slider thrown = slider("throw", "m/s", -4, 4, 0.5, 2);
    Handle top = handle({0, 8}, {0, 1}, {0, 10});
    struct Throw {
        double velocity, height, time; ///< [m/s], [m], [s]
    };
    std::vector<Throw> before;
    double clock = 0, until = 0, pause = 0; ///< [s]
    int throws = 0;

    Falling() { still_time = 5; }

    View view() const override { return {{-7, -3}, {29.4, 17.5}, Stage::moon}; }
    double velocity() const {
        constexpr double film[]{0, 3, -1};
        return untouched ? film[throws % 3] : double(thrown);
    }
    double height() const { return std::round(2 * top.at().y()) / 2; }
    void begin() override {
        clock = pause = 0;
        until = time_to_fall(height(), velocity(), moon_g);
    }
    void take_over() override { before.clear(); }
    void drag() override { begin(); }
    void changed() override { begin(); }
    void press(const Vec2 &) override { begin(); }
    void step(double dt) override {
        clock = std::min(clock + dt, until);
        if (clock < until) return;
        if (pause == 0) {
            std::erase_if(before,
                          [&](const Throw &each) { return each.velocity == velocity() && each.height == height(); });
            before.push_back({velocity(), height(), until});
            if (before.size() > 4) before.erase(before.begin());
        }
        if ((pause += dt) < 1) return;
        ++throws;
        begin();
    }

    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < before.size(); ++i) { // as high as it took long
            const double x = 9 + 4.6 * double(i), top_of_bar = 1.5 * std::min(before[i].time, 7.5);
            const Colour colour = i + 1 == before.size() ? Colour::green : Colour::blue;
            canvas.body(box({x - 0.9, 0}, {x + 0.9, top_of_bar}), colour);
            canvas.plate({x, top_of_bar + 0.9}, number(before[i].time, 2, "s"), colour, 20);
            canvas.plate({x, -0.9}, number(before[i].velocity, 1, "m/s"), Colour::ink, 16);
            canvas.plate({x, -2.1}, number(before[i].height, 1, "m"), Colour::ink, 16);
        }
        const double high = height() + velocity() * clock - moon_g * clock * clock / 2;
        canvas.bar({{-1.6, 0}, {-1.6, height()}}, Colour::wood, 8);
        canvas.bar({{-3.4, height()}, {0, height()}}, Colour::wood, 8);
        canvas.text({-2.6, height() + 1}, number(height(), 1, "m"), Colour::ink, 20, Anchor::middle);
        draw_shadow(canvas, 1.4, std::max(high, 0.0));
        const Vec2 ball{1.4, high + 0.6};
        if (clock < 0.4 && velocity() != 0)
            canvas.arrow(ball + Vec2{1.2, 0}, ball + Vec2{1.2, 0.8 * velocity()}, Colour::blue, 4);
        canvas.ball(ball, 0.6, Colour::orange);
        if (until <= 0) return;
        const Vec2 at = ball + Vec2{3, 0};
        const double turn = 2 * std::numbers::pi * std::max(0.0, 1 - clock / until);
        canvas.body(arc(at, 0.9), Colour::line);
        if (turn > 0) canvas.body(sector(at, 0.9, std::numbers::pi / 2 - turn, std::numbers::pi / 2), Colour::amber);
        canvas.plate(at + Vec2{0, 1.7}, number(until - clock, 1, "s left"), Colour::amber, 18);
    }
};
} // namespace play
