#pragma once
// Two rockets: one emits a spark a frame, the other so many a second. What becomes of them at another frame rate?
#include "shared.hpp"

namespace play {

struct Rate : Show {
    static constexpr std::string_view name = "a trail (11.7)";
    Slider rate = slider("frames per second", "", 5, 144, 1, 10);
    Particle one_a_frame = at({0, 0}), at_a_rate = at({0, 0});
    Emission emission;

    Rate() : Show(500) { still_time = 2.5; }

    World world() const override { return {1, 0, width, height}; }
    double step_time() const override { return 1 / rate; }
    /// Both fly round in circles.
    void fly(Particle &rocket, double middle) const {
        const Vec2 towards{std::cos(2.4 * time), std::sin(2.4 * time)};
        rocket.position = Vec2{middle, 6.3} + 4 * towards;
        rocket.velocity = 2.4 * 4 * Vec2{-towards.y(), towards.x()};
    }
    static Emitter tail_of(const Particle &rocket) {
        Emitter engine = engine_of(rocket);
        engine.min_life = 0.5, engine.max_life = 1.9;
        return engine;
    }
    void begin() override {
        fly(one_a_frame, 6.5);
        fly(at_a_rate, 17.5);
    }
    void step(double dt) override {
        Show::step(dt);
        fly(one_a_frame, 6.5);
        fly(at_a_rate, 17.5);
        spawn({emit(tail_of(one_a_frame), random.many(5))});
        emission = emission_count(30, emission.remainder, dt);
        for (int i = 0; i < emission.count; ++i) spawn({emit(tail_of(at_a_rate), random.many(5))});
    }

    void draw(Canvas &canvas) const override {
        draw_sparks(canvas, alive(), 0.36, 0, 0.8);
        draw_rocket(canvas, one_a_frame, 2.4);
        draw_rocket(canvas, at_a_rate, 2.4);
        canvas.text({6.5, -0.85}, "one a frame (11.6)", Colour::ink, 22, Anchor::middle);
        canvas.text({17.5, -0.85}, "30 a second (11.7)", Colour::ink, 22, Anchor::middle);
        int left = 0, right = 0;
        for (const Particle &spark : alive()) ++(spark.position.x() < width / 2 ? left : right);
        canvas.plate({6.5, 6.2}, number(left, 0, "sparks"), Colour::blue, 26);
        canvas.plate({17.5, 6.2}, number(right, 0, "sparks"), Colour::blue, 26);
    }
};
} // namespace play
