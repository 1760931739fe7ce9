#pragma once
// A dinosaur jumps over cactuses, on a screen as slow as you like.
#include "shared.hpp"

namespace play {

struct Running : Scene {
    static constexpr std::string_view name = "run and jump (12.4)";
    Slider rate = slider("frames per second", "", 10, 144, 1, 60);
    Button up = button("j", "Jump", [this] { jump(); });
    Button another = button("n", "New", [this] { put_back(run.seed + 1); }); // other cactuses
    Run run{};
    bool started = false, pressed = false; ///< since the last frame
    double time = 0, shown = 0, ouch = 0;  ///< [s]; how long the cactus hurts yet
    Vec2 fell{0, 0};                       ///< where [m]

    Running() { still_time = 2.6; }

    void put_back(unsigned seed) {
        run = {};
        run.seed = seed;
        started = pressed = false;
        time = shown = ouch = 0;
    }
    void take_over() override { put_back(0); }
    /// The first press starts the game.
    void jump() {
        pressed = started;
        started = true;
    }
    void press(const Vec2 &) override { jump(); }
    View view() const override { return {{-1.5, -0.7}, {6.5, 3.8}, Stage::yard, 0}; }
    void step(double dt) override {
        time += dt;
        if (ouch > 0 || !(started || untouched)) {
            ouch -= dt;
            shown = time;
            pressed = false;
            return;
        }
        if (untouched) pressed = pressed || near_cactus(); // it knows its way
        for (const double frame = 1 / rate; shown + frame <= time + 1e-9 && ouch <= 0; pressed = false) {
            shown += frame;
            const int falls = run.falls;
            fell = run.game.shown;
            next_frame(run, shown, pressed);
            if (run.falls > falls) ouch = 0.8;
        }
    }
    bool near_cactus() const {
        for (int number = first(); number < first() + 4; ++number)
            if (const double away = cactus(run.seed, number).x - place().x(); away > 1.9 && away < 2.2) return true;
        return false;
    }
    Vec2 place() const { return ouch > 0 ? fell : run.game.shown; }
    /// No cactus before this one is to be seen.
    int first() const { return int(std::max(0.0, (std::min(place().x(), 1e6) - 15) / 9.75)); }

    void draw(Canvas &canvas) const override {
        const double x = std::min(place().x(), 1e6);
        // Seen every so many metres, and slower by a factor than what's near
        const auto passing = [x](double every, double part, int i) { return every * i - std::fmod(part * x, every); };
        canvas.lamp({5.3, 3.1}, 0.36, Colour::amber);
        for (int i = -1; i < 4; ++i) {
            const Vec2 cloud{passing(3.7, 0.06, i), 2.75}, hill{passing(4, 0.2, i), 0};
            canvas.dots({cloud, cloud + Vec2{0.28, 0.1}, cloud + Vec2{0.56, 0}}, 0.24, Colour::ink).strength = 0.12;
            canvas
                .area({hill + Vec2{-2.2, 0}, hill + Vec2{-0.5, 1.2}, hill + Vec2{0.3, 1.4}, hill + Vec2{1.3, 0.8},
                       hill + Vec2{2.7, 0}},
                      Colour::violet)
                .strength = 0.3;
        }
        for (int i = -1; i < 9; ++i)
            canvas.line({{passing(1.1, 1, i), -0.38}, {passing(1.1, 1, i) + 0.25, -0.38}}, Colour::dim, 3).strength =
                0.7;
        for (int number = first(); cactus(run.seed, number).x < x + 7; ++number)
            if (const auto [at, height] = cactus(run.seed, number); at > x - 2)
                draw_cactus(canvas, {at - x, 0}, height);
        draw_runner(canvas, {0, std::clamp(place().y(), 0.0, 5.0)}, 1, ouch > 0 ? Colour::pink : Colour::orange, x);
        canvas.plate({-0.6, 3.35}, number(x, 0, "m"), Colour::orange, 26);
        canvas.plate({1.3, 3.35}, "best " + number(std::max(run.best, x), 0, "m"), Colour::ink, 20);
        if (ouch > 0) canvas.plate({0.1, 1.6}, "ouch", Colour::pink, 26);
        else if (!started && !untouched) canvas.plate({2.5, 1.9}, "jump to start", Colour::green, 26);
    }
    static void draw_cactus(Canvas &canvas, const Vec2 &foot, double height) {
        canvas.bar({foot + Vec2{0, 0.06}, foot + Vec2{0, height - 0.08}}, Colour::green, 15);
        for (const double side : {half_width, -half_width}) {
            const double low = (side > 0 ? 0.4 : 0.3) * height;
            canvas.bar({foot + Vec2{0, low}, foot + Vec2{side, low}, foot + Vec2{side, low + 0.35 * height}},
                       Colour::green, 8);
        }
    }
};
} // namespace play
