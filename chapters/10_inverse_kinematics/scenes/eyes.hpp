#pragma once
// Eyes that look at a fly. Where does the angle of one of them jump?
#include "shared.hpp"

namespace play {

struct Eyes : FlyScene {
    static constexpr std::string_view name = "eyes (10.1)";
    /// A bird with two eyes.
    struct Bird {
        Vec2 middle;
        double size; ///< radius of an eye [m]
        Colour colour;
    };
    const std::vector<Bird> birds{
        {{-1.2, 0.5}, 0.95, Colour::wood}, {{2.95, -0.55}, 0.55, Colour::blue}, {{-4.15, -1.55}, 0.3, Colour::violet}};

    Eyes() : FlyScene{{-5, -2.6}, {5, 3.025}} { still_time = 1; }

    Vec2 wandering() const override { return {3.6 * std::sin(1.2 * time + 1), 0.2 + 2.1 * std::sin(2 * time + 2)}; }
    void react(double) override {}

    static void draw_bird(Canvas &canvas, const Bird &bird) {
        const auto spot = [&](double x, double y) { return Vec2{bird.middle + bird.size * Vec2{x, y}}; };
        std::vector<Vec2> shape;
        for (const Vec2 &on : arc({0, 0}, 1)) shape.push_back(spot(2.25 * on.x(), -0.9 + 2.4 * on.y()));
        for (const double side : {-1.0, 1.0})
            canvas.body({spot(0.9 * side, 1.2), spot(2.1 * side, 2.2), spot(2 * side, 0)}, bird.colour);
        canvas.body(std::move(shape), bird.colour);
    }
    void draw(Canvas &canvas) const override {
        std::vector<Vec2> eyes;
        for (const auto &[middle, size, colour] : birds)
            for (const double side : {-1.0, 1.0}) eyes.push_back(middle + Vec2{1.02 * side * size, 0});
        const std::vector<double> angles = look(eyes, fly);
        for (const Bird &bird : birds) draw_bird(canvas, bird);
        canvas.bar({{-6, -2.3}, {6, -2.3}}, Colour::wood, 16);
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            const double size = birds[i / 2].size;
            canvas.ball(eyes[i], size, Colour::ink);
            canvas.ball(eyes[i] + 0.48 * size * at_angle(angles[i]), 0.5 * size, Colour::violet);
        }
        for (const auto &[middle, size, colour] : birds)
            canvas.body(
                {middle + size * Vec2{-0.35, -0.65}, middle + size * Vec2{0.35, -0.65}, middle + size * Vec2{0, -1.5}},
                Colour::amber);
        draw_fly(canvas);
        canvas.plate(eyes[0] + Vec2{-0.1, -1.45}, degrees(angles[0], 1), Colour::violet, 24);
    }
};
} // namespace play
