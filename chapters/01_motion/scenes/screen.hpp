#pragma once
// The world in metres, and beside it what a screen shows of it, in pixels that are counted from its upper left corner.
#include "shared.hpp"

namespace play {

struct OnScreen : Scene {
    static constexpr std::string_view name = "on the screen (1.8)";
    static constexpr double px = 0.034; ///< how large a pixel of the screen is drawn [m]
    Slider px_per_m = slider("pixels a metre", "px", 10, 60, 5, 20);
    Handle camera = handle({9, 7}, {2, 2}, {17, 15}, Colour::pink);
    const Vec2 size{320, 180}, corner{20.2, 16.6}; ///< of the screen [px], and where it's drawn [m]
    double time = 0;

    View view() const override { return {{0, 0}, {32, 18}, Stage::hills, 2}; }
    Vec2 helicopter() const { return {std::fmod(3 * time, 22) - 2, 9 + 2 * std::sin(0.8 * time)}; }
    Screen screen() const { return {size, camera, px_per_m}; }
    void step(double dt) override {
        time += dt;
        if (untouched) camera.move({9 + 3 * std::sin(0.7 * time), 6.5 + 1.5 * std::sin(1.1 * time)});
    }

    /// Where a pixel of the screen is drawn [m].
    Vec2 drawn(const Vec2 &pixel) const { return corner + px * Vec2{pixel.x(), -pixel.y()}; }
    bool is_on_it(const Vec2 &pixel, double margin) const {
        return pixel.minCoeff() > margin && (size - pixel).minCoeff() > margin;
    }
    void draw(Canvas &canvas) const override {
        const Screen shown = screen();
        const Vec2 half = size / shown.px_per_m / 2, centre = shown.centre;
        draw_things(
            canvas, [](const Vec2 &place) { return place; }, 1, [](const Vec2 &, double) { return true; });
        std::vector<Vec2> frame = box(centre - half, centre + half);
        frame.push_back(frame.front());
        canvas.dotted(std::move(frame), Colour::pink, 4);

        const Vec2 low = drawn({0, size.y()}), high = drawn({size.x(), 0}), rim{0.35, 0.35};
        canvas.body(box(low - rim, high + rim), Colour::ink);
        canvas.area(box(low, high), Colour::line);
        draw_things(
            canvas, [&](const Vec2 &place) { return drawn(to_screen(place, shown)); }, shown.px_per_m * px,
            [&](const Vec2 &place, double radius) {
                return is_on_it(to_screen(place, shown), radius * shown.px_per_m);
            });
        const Vec2 pixel = to_screen(helicopter(), shown);
        canvas.plate({(low.x() + high.x()) / 2, low.y() - 1.4},
                     "(" + number(pixel.x(), 0) + ", " + number(pixel.y(), 0) + ") px", Colour::blue, 22);
        canvas.plate({5, 16.8}, "(" + number(helicopter().x(), 1) + ", " + number(helicopter().y(), 1) + ") m",
                     Colour::blue, 22);
    }
    /// What's in the world: a house, lamps, and a helicopter.
    template <class Place, class Seen>
    void draw_things(Canvas &canvas, const Place &place, double scale, const Seen &seen) const {
        const auto body = [&](std::vector<Vec2> corners, Colour colour) {
            for (const Vec2 &each : corners)
                if (!seen(each, 0)) return;
            for (Vec2 &each : corners) each = place(each);
            canvas.body(std::move(corners), colour);
        };
        body(box({5, 2}, {9, 5}), Colour::wood);
        body({{4.6, 5}, {9.4, 5}, {7, 6.8}}, Colour::pink);
        body(box({6.4, 2}, {7.4, 4}), Colour::ink);
        for (const double x : {2.0, 12.0, 16.0}) {
            body(box({x - 0.1, 2}, {x + 0.1, 5}), Colour::ink);
            if (seen({x, 5.3}, 0.5)) canvas.lamp(place({x, 5.3}), 0.4 * scale, Colour::amber);
        }
        if (seen(helicopter(), 2)) draw_helicopter(canvas, place(helicopter()), 4 * scale, time);
    }
};
} // namespace play
