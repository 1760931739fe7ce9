#pragma once
// Two helicopters, both 4 px a frame: one screen shows 30 frames a second, and the reader sets the other's.
#include "shared.hpp"

namespace play {

struct Speeds : Scene {
    static constexpr std::string_view name = "a speed (1.1)";
    static constexpr double wide = 640; // [px]
    Slider rate = slider("lower frame rate", "frame/s", 10, 120, 10, 20);
    struct Screen {
        double rate = 30;                      ///< [frame/s]
        Helicopter helicopter{{0, 0}, {0, 0}}; ///< [px]
        double due = 0;                        ///< [frame]
        int frames = 0;                        ///< until it was across
        bool across = false;
    };
    Screen screens[2];
    double time = 0, pause = 0; ///< [s]

    Speeds() { still_time = 3; }

    View view() const override { return {{0, 0}, {wide, 360}, Stage::hills, 34}; }
    void begin() override {
        const double rates[]{30, rate}, heights[]{262, 122};
        for (int i = 0; i < 2; ++i) screens[i] = {rates[i], {{0, heights[i]}, {px_per_second(4, rates[i]), 0}}};
        pause = 0;
    }
    void take_over() override { begin(); }
    void changed() override { begin(); }
    void press(const Vec2 &) override { begin(); }
    void step(double dt) override {
        time += dt;
        for (Screen &screen : screens)
            for (screen.due += dt * screen.rate; screen.due >= 1; --screen.due) {
                if (screen.across) continue;
                next_frame(screen.helicopter, 1 / screen.rate);
                ++screen.frames;
                screen.across = screen.helicopter.position.x() > wide - 1e-6;
            }
        if (screens[0].across && screens[1].across && (pause += dt) > 2.5) begin();
    }

    void draw(Canvas &canvas) const override {
        for (int x = 100; x < wide; x += 100) {
            canvas.line({{double(x), 34}, {double(x), 22}}, Colour::ink, 2);
            canvas.text({double(x), 10}, number(x, 0), Colour::ink, 16, Anchor::middle);
        }
        for (const Screen &screen : screens) {
            const Vec2 at = screen.helicopter.position;
            canvas.dotted({{0, at.y()}, at}, Colour::blue, 3);
            draw_helicopter(canvas, at, 130, time);
            canvas.plate({112, at.y() + 58}, number(screen.rate, 0, "frames a second"), Colour::ink, 18);
            canvas.plate({std::clamp(at.x(), 76.0, wide - 180), at.y() - 54},
                         number(screen.helicopter.velocity.x(), 0, "px/s"), Colour::blue, 26);
            if (!untouched)
                canvas.plate({wide - 48, at.y() - 54}, number(screen.frames / screen.rate, 2, "s"),
                             screen.across ? Colour::green : Colour::dim, 24);
        }
    }
};
} // namespace play
