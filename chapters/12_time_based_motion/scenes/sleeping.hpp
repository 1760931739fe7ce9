#pragma once
// A tab sleeps, and a ship flies on in its sleep: past the rings.
#include "shared.hpp"

namespace play {

struct Sleeping : Scene {
    static constexpr std::string_view name = "a tab that sleeps (12.2)";
    static constexpr double rings[]{210, 280, 350, 430}; ///< [px]
    static constexpr double reach = 16;                  ///< a ship in a ring is so near to it [px]
    Button sleep = button("s", "Sleep for 2 s", [this] { asleep = 2; });
    Button back = button("b", "Clock back by an hour", [this] { machine = std::max(0.0, machine - 3600); });
    Tab tab{};
    double machine = 20000, asleep = 0; ///< what the machine's clock shows; how long the tab sleeps yet [s]
    double time = 0;                    ///< [s]
    bool slept = false;                 ///< by itself, in this round
    bool through[2][4]{};               ///< which rings the two ships came through in this round

    Sleeping() { still_time = 3; }

    void begin() override {
        tab = {{}, {0, cruise}, {0, cruise}};
        machine = tab.clock.last = 20000;
        time = asleep = 0;
        slept = false;
        for (auto &ship : through)
            for (bool &each : ship) each = false;
    }
    /// As if it hadn't slept.
    void take_over() override {
        tab.raw = tab.ship;
        std::copy(through[0], through[0] + 4, through[1]);
        asleep = 0;
        slept = true;
    }
    View view() const override { return {{-34, -4}, {654, 383}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        machine += dt;
        // By itself it sleeps for a second, and long before the rings.
        if (untouched && !slept && tab.ship.x > 30) asleep = 1, slept = true;
        asleep = std::max(0.0, asleep - dt);
        if (asleep > 0) return; // no frames
        tab = next_frame(tab, machine);
        for (int i = 0; i < 4; ++i) {
            through[0][i] = through[0][i] || std::abs(tab.ship.x - rings[i]) <= reach;
            through[1][i] = through[1][i] || std::abs(tab.raw.x - rings[i]) <= reach;
        }
        if (tab.ship.x > 680 || time > 9) begin();
    }

    void draw(Canvas &canvas) const override {
        for (int i = 0; i < 2; ++i) {
            const double low = i == 0 ? 194 : 0, y = low + 76, x = (i == 0 ? tab.ship : tab.raw).x;
            const Colour colour = i == 0 ? Colour::blue : Colour::orange;
            draw_screen(canvas, {-26, low}, {646, low + 182});
            canvas.text({-12, low + 161}, i == 0 ? "by your clock" : "by the plain difference", colour, 18);
            for (int k = 0; k < 4; ++k) draw_half(canvas, {rings[k], y}, -1, through[i][k]);
            draw_ship(canvas, {std::clamp(x, -2000.0, 2000.0), y}, 84, colour, asleep > 0 ? 0 : time);
            for (int k = 0; k < 4; ++k) draw_half(canvas, {rings[k], y}, 1, through[i][k]);
            const auto count = std::count(through[i], through[i] + 4, true);
            canvas.plate({560, low + 157}, number(double(count), 0) + " of 4 rings",
                         count == 4 ? Colour::green : Colour::ink, 20);
            if (x < -30) canvas.plate({110, y}, "← it's at " + number(x, 0, "px"), colour, 20);
            else if (x > 660) canvas.plate({560, y}, number(x, 0, "px") + " →", colour, 20);
        }
        if (asleep <= 0) return;
        canvas.area(box({-34, -4}, {654, 383}), Colour::line).strength = 0.5;
        canvas.plate({310, 188}, "z z z: it wakes up in " + number(asleep, 1, "s"), Colour::violet, 24);
    }
    /// One half of a ring, behind the ship or in front of it.
    static void draw_half(Canvas &canvas, const Vec2 &centre, double side, bool lit) {
        std::vector<Vec2> points;
        for (const Vec2 &at : arc({0, 0}, 1, std::numbers::pi / 2, -std::numbers::pi / 2))
            points.push_back(centre + Vec2{side * 12 * at.x(), 58 * at.y()});
        if (lit) canvas.beam(std::move(points), Colour::green, 4);
        else canvas.bar(std::move(points), Colour::amber, 5);
    }
};
} // namespace play
