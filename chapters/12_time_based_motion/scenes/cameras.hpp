#pragma once
// Two pairs of flying cameras follow a lamp: on a slow screen and a fast one.
#include "shared.hpp"

namespace play {

struct TwoCameras : Scene {
    static constexpr std::string_view name = "two cameras (12.5)";
    Slider half_life = slider("half-life", "s", 0.01, 0.5, 0.005, 0.1);
    Handle target = handle({1.3, 1.2}, {-4.8, -2.1}, {4.8, 2.1}); ///< [m]
    Cameras slow{}, quick{};
    double shown[2]{}, time = 0; ///< [s]

    View view() const override { return {{-5.6, -3.15}, {5.6, 3.15}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        if (untouched) target.move({4 * std::sin(1.6 * time), 1.9 * std::sin(2.5 * time + 0.6)});
        for (int due = frames_due(shown[0], 1.0 / 30, time); due > 0; --due)
            slow = next_frame(slow, target, half_life, 1.0 / 30);
        for (int due = frames_due(shown[1], 1.0 / 144, time); due > 0; --due)
            quick = next_frame(quick, target, half_life, 1.0 / 144);
    }

    void draw(Canvas &canvas) const override {
        const Vec2 to = target;
        canvas.dotted({slow.tenth, quick.tenth, to}, Colour::orange);
        canvas.dotted({slow.ours, to}, Colour::blue);
        draw_drone(canvas, slow.tenth, 1.4, Colour::orange);
        draw_drone(canvas, slow.ours, 1.4, Colour::blue);
        draw_drone(canvas, quick.tenth, 0.85, Colour::orange);
        draw_drone(canvas, quick.ours, 0.85, Colour::blue);
        canvas.lamp(to, 0.13, Colour::pink);
        const auto apart = [](const Vec2 &one, const Vec2 &other) {
            return number((one - other).norm(), 2, "m apart");
        };
        canvas.plate({-2.8, 2.88}, "a tenth a frame: " + apart(slow.tenth, quick.tenth), Colour::orange, 18);
        canvas.plate({2.8, 2.88}, "by half-life: " + apart(slow.ours, quick.ours), Colour::blue, 18);
        canvas.text({0, -2.9}, "large: 30 frames a second, small: 144", Colour::ink, 16, Anchor::middle);
        canvas.readout("a tenth at 144: behind", (quick.tenth - to).norm(), "m");
        canvas.readout("by half-life at 144: behind", (quick.ours - to).norm(), "m");
    }
    static void draw_drone(Canvas &canvas, const Vec2 &at, double size, Colour colour) {
        constexpr double outline[][2]{{-50, -25}, {-35, -40}, {35, -40}, {50, -25},
                                      {50, 20},   {35, 35},   {-35, 35}, {-50, 20}};
        canvas.bar({at + size * Vec2{-0.75, 0.42}, at + size * Vec2{0.75, 0.42}}, Colour::dim, 4);
        std::vector<Vec2> corners;
        for (const auto &[x, y] : outline) corners.push_back(at + 0.01 * size * Vec2{x, y});
        canvas.body(std::move(corners), colour);
        canvas.ball(at, 0.24 * size, Colour::ink);
    }
};
} // namespace play
