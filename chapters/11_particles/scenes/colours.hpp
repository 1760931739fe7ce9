#pragma once
// A spark's age is its colour: three sparks, large, and a lamp for the shade that they have now.
#include "shared.hpp"

namespace play {

struct Colours : Show {
    static constexpr std::string_view name = "colours (11.2)";
    Button again = button("x", "Burst", [this] { throw_three({12, 1.9}); });

    Colours() : Show(30) { still_time = 1.1; }

    World world() const override { return {8, 0, width, 2 * height}; } // they go out by age alone
    void press(const Vec2 &place) override { throw_three(place.cwiseMax(Vec2{9.5, 1.5}).cwiseMin(Vec2{14.5, 5})); }
    void throw_three(const Vec2 &place) {
        since = 0;
        for (Particle spark : three_sparks(place)) {
            spark.velocity = {1.3 * spark.velocity.x(), 1.35 * spark.velocity.y()};
            spark.life = 2.4;
            spawn({spark});
        }
    }
    void begin() override { throw_three({12, 1.9}); }
    void step(double dt) override {
        Show::step(dt);
        if (since > 2.55) throw_three({12, 1.9});
    }

    void draw(Canvas &canvas) const override {
        draw_sparks(canvas, alive(), 0.9, 0.25, 1);
        std::vector<bool> lit(shades);
        for (const Particle &spark : alive())
            if (const auto shade = shade_index(spark.age, spark.life, shades); shade && *shade >= 0 && *shade < shades)
                lit[std::size_t(*shade)] = true;
        for (int i = 0; i < shades; ++i) {
            const double left = 2.1 + 2.5 * i;
            const std::vector<Vec2> lamp = box({left, -1}, {left + 2.3, 0.3});
            if (lit[std::size_t(i)]) canvas.body(lamp, colour_of(i));
            else canvas.area(lamp, Colour::dim).strength = 0.35;
            canvas.text({left + 1.15, -0.58}, number(i, 0), Colour::ink, 18, Anchor::middle);
        }
    }
};
} // namespace play
