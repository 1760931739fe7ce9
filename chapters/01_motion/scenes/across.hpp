#pragma once
// A helicopter at a constant velocity: its arrow ends where it is after a second. Who sends it to the lamp in time?
#include "shared.hpp"

namespace play {

struct Across : Scene {
    static constexpr std::string_view name = "across the screen (1.2)";
    static constexpr double wide = 640, high = 360; // of the screen [px]
    const Vec2 start{20, 80}, lamp{560, 250};       // [px]
    Handle tip = handle({140, 80}, {30, 80}, {340, 300});
    Helicopter helicopter{start, {0, 0}};
    double time = 0;                ///< since it started [s]
    double left_at = -1, level = 0; ///< when it left the screen [s], and how high it was [px]
    int flights = 0;

    Across() { still_time = 2.6; }

    View view() const override { return {{0, 0}, {wide, high}, Stage::hills, 34}; }
    void fly() {
        constexpr double film[][2]{{150, 95}, {115, 130}, {168, 110}};
        if (untouched) tip.move({film[flights % 3][0], film[flights % 3][1]});
        ++flights;
        helicopter = {start, tip.at() - start};
        time = 0;
        left_at = -1;
    }
    void begin() override { fly(); }
    void take_over() override { tip.move(start + Vec2{px_per_second(4, 30), 0}); }
    void press(const Vec2 &) override { fly(); }
    void let_go() override { fly(); }
    void drag() override { fly(); }
    void step(double dt) override {
        time += dt;
        next_frame(helicopter, dt);
        Vec2 &at = helicopter.position;
        if (at.x() > wide) { // it comes back on the left, or from below
            if (left_at < 0) left_at = time - (at.x() - wide) / helicopter.velocity.x(), level = at.y();
            at.x() -= wide;
        }
        if (at.y() > high) at.y() -= high - 34;
        if (untouched && left_at > 0 && time > left_at + 1.5) fly();
    }

    void draw(Canvas &canvas) const override {
        const Vec2 velocity = tip.at() - start, fourth = uniform_motion(start, velocity, 4);
        const double off = (fourth - lamp).norm(); // [px]
        std::vector<Vec2> seconds;
        for (int k = 0; k <= 12; ++k)
            if (const Vec2 at = uniform_motion(start, velocity, k); at.x() < wide + 20) seconds.push_back(at);
        canvas.bar({{lamp.x(), 30}, lamp}, Colour::wood, 5);
        canvas.lamp(lamp, 12, Colour::amber);
        canvas.plate(lamp + Vec2{0, 34}, "after 4 s?", Colour::ink, 18);
        canvas.dotted({fourth, lamp}, Colour::violet, 3);
        canvas.dots(std::move(seconds), 5, Colour::blue);
        canvas.dot(fourth, 8, Colour::violet);
        canvas.arrow(start, tip, Colour::blue, 4);
        draw_helicopter(canvas, helicopter.position, 130, time);
        if (off < 8) canvas.plate(lamp + Vec2{0, -30}, "in time", Colour::green, 24);
        else
            canvas.plate(((fourth + lamp) / 2).cwiseMin(Vec2{wide - 60, high - 20}), number(off, 0, "px off"),
                         Colour::violet, 18);
        canvas.plate({tip.at().x(), 16}, "(" + number(velocity.x(), 0) + ", " + number(velocity.y(), 0) + ") px/s",
                     Colour::blue, 20);
        if (left_at > 0)
            canvas.plate({wide - 52, std::clamp(level, 60.0, high - 30)}, number(left_at, 2, "s"), Colour::green, 24);
        canvas.readout("time", time, "s", 1);
    }
};
} // namespace play
