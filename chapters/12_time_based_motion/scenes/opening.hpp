#pragma once
// Who arrives first, and where's the other ship then?
#include "shared.hpp"

namespace play {

struct Opening : Scene {
    static constexpr std::string_view name = "who's first?";
    static constexpr double y = -150;                             ///< of your ship [px]
    Handle guess = handle({600, y}, {0, y}, {finish, y});         ///< where its nose will be
    Button show = button("f", "Show", [this] { start(); });       // both fly
    Button another = button("n", "New", [this] { next_pair(); }); // other screens
    int round = 0, guesses = 0;
    double time = 0, flown = -1; ///< [s]; how long the two ships have flown, -1: they wait
    double misses[5]{};          ///< of the last five guesses [px]

    /// Two screens, and a ship that flies so far in a frame.
    struct Pair {
        double yours, other, speed; ///< [1/s], [1/s], [px]
    };
    Pair pair() const {
        if (round == 0) return {60, 144, 2};
        constexpr double slow[]{30, 50, 60, 75}, fast[]{90, 120, 144, 165, 240};
        const auto one_of = [this](const auto &all, unsigned which) {
            return all[int(course::chance(unsigned(round), which) * double(std::size(all)))];
        };
        return {one_of(slow, 1), one_of(fast, 2), course::chance(unsigned(round), 3) < 0.5 ? 2.0 : 3.0};
    }
    double truth() const { return finish * pair().yours / pair().other; }  ///< where your ship is then [px]
    double flight() const { return finish / pair().speed / pair().other; } ///< how long your friend's flies [s]

    void start() {
        if (flown < 0) misses[guesses++ % 5] = guess.at().x() - truth();
        flown = 0;
    }
    void next_pair() {
        ++round;
        flown = -1;
    }
    void drag() override { flown = -1; }
    View view() const override { return {{-125, -277}, {860, 277}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        if (untouched) guess.move({605 + 165 * std::sin(1.6 * time), y}); // it only wonders, and not near the answer
        if (flown >= 0) flown += dt;
    }

    void draw(Canvas &canvas) const override {
        const auto [own, other, speed] = pair();
        const double friends = untouched ? std::min(std::fmod(time, 3.6), flight()) : std::clamp(flown, 0.0, flight());
        const double x = guess.at().x(), yours = speed * own * std::clamp(flown, 0.0, flight());
        for (const double low : {12.0, -268.0}) {
            draw_screen(canvas, {-115, low}, {850, low + 256});
            draw_chequers(canvas, {finish, low + 4}, 15.5, 16);
        }
        canvas.text({-95, 238}, "your friend: " + number(other, 0) + " frames a second", Colour::blue, 18);
        canvas.text({-95, -36}, "you: " + number(own, 0) + " frames a second", Colour::orange, 18);
        canvas.text({-95, 40}, number(speed, 0) + " px in each frame", Colour::ink, 16);
        for (int mark = 0; mark < 800; mark += 100) {
            canvas.line({{double(mark), -262}, {double(mark), mark % 200 == 0 ? -232.0 : -248.0}}, Colour::dim, 1.5);
            if (mark % 200 == 0) canvas.text({mark + 8.0, -246}, number(mark, 0), Colour::dim, 15);
        }
        draw_ship(canvas, {speed * other * friends, 135}, 100, Colour::blue, time);
        if (!untouched) draw_ship(canvas, {yours, y}, 100, Colour::orange, time); // or else you'd see where it is
        draw_ghost(canvas, {x, y}, 100, Colour::pink);
        if (flown < flight()) {
            if (flown < 0) canvas.plate({std::min(x - 55, 680.0), -85}, "yours, then?", Colour::pink, 20);
            return;
        }
        for (int i = 0; i < std::min(guesses, 5); ++i)
            canvas.lamp({std::clamp(yours + misses[i], -110.0, 845.0), -218}, 7, Colour::amber);
        canvas.line({{yours, y}, {x, y}}, Colour::pink, 3);
        const double off = std::abs(x - yours);
        const std::string there = "at " + number(yours, 0, "px"), away = number(off, 0, "px off");
        const Colour colour = off < 20 ? Colour::green : Colour::pink;
        if (off < 230) {
            canvas.plate({std::clamp((x + yours) / 2 - 50, 60.0, 650.0), -85}, there + ", " + away, colour);
            return;
        }
        canvas.plate({std::min(yours - 50, 680.0), -85}, there, Colour::orange);
        canvas.plate({std::clamp(x - 50, -25.0, 680.0), -85}, away, colour);
    }
};
} // namespace play
